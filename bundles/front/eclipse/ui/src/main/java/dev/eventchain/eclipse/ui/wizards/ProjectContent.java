package dev.eventchain.eclipse.ui.wizards;

import dev.eventchain.eclipse.Program;
import dev.eventchain.eclipse.ui.EventchainUi;
import dev.eventchain.project.ProjectLayout;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.regex.Matcher;
import java.util.stream.Stream;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IPath;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.OperationCanceledException;
import org.eclipse.core.runtime.Status;

/** Fills the folder of a new project, or restores it. */
final class ProjectContent {

  /** Examples that ship with the program. */
  static final List<String> EXAMPLES =
      List.of("aeb", "acc", "lane-departure", "child-presence", "radar-aeb", "cut-in");

  private final Program program;
  private final Path folder;
  private final boolean existed;

  /**
   * @param folder a missing or empty folder
   */
  ProjectContent(Program program, Path folder) {
    this.program = program;
    this.folder = folder;
    this.existed = Files.exists(folder);
  }

  /** Returns whether a folder is missing or empty; false if it cannot be read. */
  static boolean isFree(Path folder) {
    if (!Files.exists(folder)) {
      return true;
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files.findAny().isEmpty();
    } catch (IOException e) {
      return false;
    }
  }

  /** Returns the innermost existing folder, in which a new folder is created. */
  static Path existing(Path folder) {
    Path found = folder.toAbsolutePath();
    while (!Files.exists(found) && found.getParent() != null) {
      found = found.getParent();
    }
    return found;
  }

  /** Returns the folder of an example next to the program, following links. */
  static Path example(Program program, String name) throws CoreException {
    try {
      Path home = program.file().toRealPath().getParent();
      Path example = home.resolve("examples").resolve(name);
      if (Files.isDirectory(example)) {
        return example;
      }
      throw failure("There is no folder " + example + " next to the program.", null);
    } catch (IOException e) {
      throw failure("The program cannot be read: " + e.getMessage(), e);
    }
  }

  /**
   * Creates the starter project with the program, under the name of the chain.
   *
   * @throws CoreException if the program fails, with its output
   */
  void start(String chain, IProgressMonitor monitor) throws CoreException {
    StringBuffer said = new StringBuffer();
    Path place = existing(folder);
    int code = program.run(List.of("init", folder.toString()), place, said::append, monitor);
    if (code != 0) {
      throw failure("The program could not start a project: " + said.toString().strip(), null);
    }
    try {
      rename(ProjectLayout.CONFIGURATION, "(?m)^(name:\\s*).*$", "$1" + chain);
      String name = "(<eventchain:EventChain\\b[^>]*?\\sname=\")[^\"]*";
      rename(ProjectLayout.MODEL, name, "$1" + chain);
    } catch (IOException e) {
      throw failure("The chain could not be named: " + e.getMessage(), e);
    }
  }

  private void rename(String file, String pattern, String by) throws IOException {
    Path path = folder.resolve(file);
    if (Files.isRegularFile(path)) {
      String text = Files.readString(path);
      Matcher name = java.util.regex.Pattern.compile(pattern).matcher(text);
      Files.writeString(path, name.replaceFirst(by));
    }
  }

  /**
   * Copies an example without its results.
   *
   * @throws OperationCanceledException if it was cancelled
   */
  void copy(Path example, IProgressMonitor monitor) throws CoreException {
    try (Stream<Path> walk = Files.walk(example)) {
      Path results = example.resolve(ProjectLayout.OUTPUT);
      for (Path file : walk.filter(each -> !each.startsWith(results)).sorted().toList()) {
        if (monitor.isCanceled()) {
          throw new OperationCanceledException();
        }
        Path target = folder.resolve(example.relativize(file).toString());
        if (Files.isDirectory(file)) {
          Files.createDirectories(target);
        } else if (!file.getFileName().toString().equals(".project")) {
          Files.copy(file, target);
        }
      }
    } catch (IOException | java.io.UncheckedIOException e) {
      throw failure("The example cannot be copied: " + e.getMessage(), e);
    }
  }

  /**
   * Checks that the folder is still missing or empty, since {@link #undo} deletes all of it.
   *
   * @throws CoreException if it is not
   */
  void requireFree() throws CoreException {
    if (!isFree(folder)) {
      throw failure("There is now something in " + folder + ", which was empty.", null);
    }
  }

  /** Returns whether the project's folder is the one that is filled here. */
  boolean isIn(IPath location) {
    return location != null && location.toPath().equals(folder);
  }

  /** Deletes everything that was written. */
  void undo() throws CoreException {
    if (!Files.exists(folder)) {
      return;
    }
    try (Stream<Path> walk = Files.walk(folder)) {
      for (Path file : walk.sorted(Comparator.reverseOrder()).toList()) {
        if (!existed || !file.equals(folder)) {
          Files.delete(file);
        }
      }
    } catch (IOException | java.io.UncheckedIOException e) {
      throw failure("What was written cannot be removed: " + e.getMessage(), e);
    }
  }

  static CoreException failure(String message, Throwable cause) {
    return new CoreException(new Status(IStatus.ERROR, EventchainUi.ID, message, cause));
  }
}
