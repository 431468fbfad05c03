package dev.eventchain.eclipse.install;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.zip.ZipEntry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The workbench, started by its script. */
class WorkbenchTest {

  /** Exit status that a shell reports for a process ended by SIGTERM. */
  private static final int ENDED_BY_SIGTERM = 143;

  /** Mark of an entry of severity error in the error log. */
  private static final String ERROR = "!ENTRY \\S+ 4 .*";

  @TempDir Path scratch;

  @Test
  void startsWithOurPerspectiveAndEndsOnSigterm() throws Exception {
    assumeTrue(System.getenv("DISPLAY") != null, "there is no display: DISPLAY is not set");
    Installation workbench = Installation.copy(scratch);
    workbench.add("dev.eventchain.eclipse.install.probe", probe());
    Path workspace = scratch.resolve("workspace");
    Path printed = scratch.resolve("printed.txt");
    Process process = workbench.start(workspace, printed, Map.of(), List.of("-consoleLog"));
    Installation.await(workspace.resolve(StartProbe.FILE), process, printed);
    process.destroy();
    assertEquals(
        ENDED_BY_SIGTERM, Installation.end(process, printed), () -> Installation.read(printed));

    assertEquals(List.of(), errors(workspace), () -> Installation.read(printed));
    String shown = Files.readString(workspace.resolve(StartProbe.FILE));
    assertTrue(shown.contains("elementId=\"dev.eventchain.eclipse.ui.perspective\""), shown);
    assertTrue(shown.contains("elementId=\"org.eclipse.ui.views.ProblemView\""), shown);
  }

  @Test
  void saysThatThereIsNoJava() throws Exception {
    Path printed = scratch.resolve("printed.txt");
    Path nothing = Files.createDirectory(scratch.resolve("jdk"));
    assertRefuses(nothing, "there is no " + nothing + "/bin/java; install Java 17", printed);
  }

  @Test
  void saysThatJavaIsTooOld() throws Exception {
    Path printed = scratch.resolve("printed.txt");
    Path java = scratch.resolve("jdk/bin/java");
    Files.createDirectories(java.getParent());
    Files.writeString(java, "#!/bin/sh\necho 'openjdk version \"11.0.2\" 2019-01-15' >&2\n");
    assertTrue(java.toFile().setExecutable(true));
    assertRefuses(scratch.resolve("jdk"), java + " is Java 11; set JAVA_HOME", printed);
  }

  private void assertRefuses(Path javaHome, String message, Path printed) throws Exception {
    Installation workbench = new Installation(Built.WORKBENCH, scratch);
    Map<String, String> variables = Map.of("JAVA_HOME", javaHome.toString());
    Process process = workbench.start(scratch.resolve("workspace"), printed, variables, List.of());
    assertEquals(3, Installation.end(process, printed));
    String said = Files.readString(printed);
    assertTrue(said.startsWith("eventchain-workbench: " + message), said);
  }

  private static List<String> errors(Path workspace) throws IOException {
    Path log = workspace.resolve(".metadata/.log");
    if (!Files.exists(log)) {
      return List.of();
    }
    return Files.readAllLines(log).stream().filter(line -> line.matches(ERROR)).toList();
  }

  /** Returns the bundle that notices the start. */
  private Path probe() throws IOException {
    Manifest manifest = new Manifest();
    Attributes attributes = manifest.getMainAttributes();
    attributes.put(Attributes.Name.MANIFEST_VERSION, "1.0");
    attributes.putValue("Bundle-ManifestVersion", "2");
    attributes.putValue("Bundle-SymbolicName", "dev.eventchain.eclipse.install.probe");
    attributes.putValue("Bundle-Version", "1.0.0");
    attributes.putValue("Bundle-Activator", StartProbe.class.getName());
    attributes.putValue("Import-Package", "org.osgi.framework,org.osgi.service.event");
    Path jar = scratch.resolve("probe.jar");
    String entry = StartProbe.class.getName().replace('.', '/') + ".class";
    try (OutputStream file = Files.newOutputStream(jar);
        JarOutputStream out = new JarOutputStream(file, manifest)) {
      out.putNextEntry(new ZipEntry(entry));
      out.write(StartProbe.class.getResourceAsStream("/" + entry).readAllBytes());
    }
    return jar;
  }
}
