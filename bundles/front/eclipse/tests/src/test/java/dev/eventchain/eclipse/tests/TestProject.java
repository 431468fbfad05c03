package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.eclipse.EventchainCore;
import dev.eventchain.eclipse.FindingMarker;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.core.resources.IContainer;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IFolder;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.IWorkspace;
import org.eclipse.core.resources.IWorkspaceDescription;
import org.eclipse.core.resources.IncrementalProjectBuilder;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IPath;
import org.eclipse.core.runtime.NullProgressMonitor;

/** A project in the test's workspace, which is built on demand. */
final class TestProject implements AutoCloseable {

  /** The chain of the example. */
  static final String CHAIN = "model/chain.xmi";

  private static final Path EXAMPLES = Path.of("..", "..", "..", "..", "examples").toAbsolutePath();

  private final IProject project;

  private TestProject(IProject project) {
    this.project = project;
  }

  /** Returns an empty project with our nature. */
  static TestProject create(String name) throws CoreException {
    IWorkspace workspace = ResourcesPlugin.getWorkspace();
    IWorkspaceDescription description = workspace.getDescription();
    description.setAutoBuilding(false);
    workspace.setDescription(description);
    IProject project = workspace.getRoot().getProject(name);
    if (project.exists()) {
      project.delete(true, true, null);
    }
    project.create(null);
    project.open(null);
    EventchainCore.setNature(project, true, new NullProgressMonitor());
    return new TestProject(project);
  }

  /** Returns a project with a copy of an example: the one with an edited chain. */
  static TestProject ofRadarExample(String name) throws CoreException, IOException {
    TestProject project = create(name);
    Path example = EXAMPLES.resolve("radar-aeb").normalize();
    try (Stream<Path> files = Files.walk(example)) {
      for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
        String relative = example.relativize(file).toString();
        if (!relative.startsWith("out")) {
          project.write(
              relative,
              Files.readString(file, StandardCharsets.ISO_8859_1),
              StandardCharsets.ISO_8859_1);
        }
      }
    }
    return project;
  }

  IProject project() {
    return project;
  }

  IFile file(String name) {
    return project.getFile(IPath.fromOSString(name));
  }

  String text(String name) throws IOException {
    return Files.readString(file(name).getLocation().toPath());
  }

  /** Saves a file as an editor does. */
  IFile write(String name, String text) throws CoreException {
    return write(name, text, StandardCharsets.UTF_8);
  }

  private IFile write(String name, String text, java.nio.charset.Charset charset)
      throws CoreException {
    IFile file = file(name);
    ByteArrayInputStream content = new ByteArrayInputStream(text.getBytes(charset));
    if (file.exists()) {
      file.setContents(content, true, true, null);
    } else {
      create(file.getParent());
      file.create(content, true, null);
    }
    return file;
  }

  private static void create(IContainer container) throws CoreException {
    if (container instanceof IFolder folder && !folder.exists()) {
      create(folder.getParent());
      folder.create(true, true, null);
    }
  }

  /** Replaces a text that occurs once in a file. */
  void replace(String name, String text, String by) throws CoreException, IOException {
    String before = text(name);
    assertTrue(before.indexOf(text) >= 0 && before.indexOf(text) == before.lastIndexOf(text), text);
    write(name, before.replace(text, by));
  }

  /** Builds the changes, and expects exactly these markers. */
  void buildsTo(String... expected) throws CoreException {
    build();
    assertEquals(List.of(expected), markers());
  }

  /** Builds the changes. */
  void build() throws CoreException {
    project.build(IncrementalProjectBuilder.INCREMENTAL_BUILD, null);
  }

  /** Returns our markers as texts: {@code error model/chain.xmi:12 ocl.violated}. */
  List<String> markers() throws CoreException {
    return Arrays.stream(found()).map(TestProject::text).sorted().toList();
  }

  IMarker[] found() throws CoreException {
    return project.findMarkers(EventchainCore.PROBLEM, true, IResource.DEPTH_INFINITE);
  }

  /** Returns the only marker with an identifier. */
  IMarker marker(String id) throws CoreException {
    List<IMarker> found =
        Arrays.stream(found())
            .filter(each -> each.getAttribute(FindingMarker.ID, "").equals(id))
            .toList();
    assertTrue(found.size() == 1, id + " in " + markers());
    return found.get(0);
  }

  private static String text(IMarker marker) {
    List<String> severities = List.of("info", "warning", "error");
    int line = marker.getAttribute(IMarker.LINE_NUMBER, 0);
    return severities.get(marker.getAttribute(IMarker.SEVERITY, 0))
        + " "
        + marker.getResource().getProjectRelativePath()
        + (line > 0 ? ":" + line : "")
        + " "
        + marker.getAttribute(FindingMarker.ID, "");
  }

  @Override
  public void close() throws CoreException {
    project.delete(true, true, null);
  }
}
