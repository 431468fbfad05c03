package dev.eventchain.maven;

import dev.eventchain.diagnostics.Diagnostic;
import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.codehaus.plexus.util.DirectoryScanner;

/** A set of models in a folder, as configured in a pom. */
public final class ModelFiles {

  /** The folder. */
  private File directory;

  /** Patterns such as {@code **}{@code /*.xmi}. */
  private List<String> includes = new ArrayList<>();

  /** Patterns of excluded files, besides those of version control. */
  private List<String> excludes = new ArrayList<>();

  /** Creates an empty set, for Maven. */
  public ModelFiles() {}

  ModelFiles(File directory, String include) {
    this.directory = directory;
    this.includes = List.of(include);
  }

  /** Returns whether the folder exists. */
  boolean isThere() {
    return directory != null && directory.isDirectory();
  }

  /** Returns the files in the order of their names; none if the folder does not exist. */
  List<Path> files() {
    if (!isThere()) {
      return List.of();
    }
    DirectoryScanner scanner = new DirectoryScanner();
    scanner.setBasedir(directory);
    if (!includes.isEmpty()) {
      scanner.setIncludes(includes.toArray(String[]::new));
    }
    scanner.setExcludes(excludes.toArray(String[]::new));
    scanner.addDefaultExcludes();
    scanner.scan();
    return Arrays.stream(scanner.getIncludedFiles())
        .sorted()
        .map(name -> Places.shown(new File(directory, name)))
        .toList();
  }

  /**
   * Returns a finding if nothing matches, which may be due to a wrong pattern and must not pass as
   * a check.
   */
  Optional<Diagnostic> nothing() {
    if (!files().isEmpty()) {
      return Optional.empty();
    }
    String message =
        directory == null
            ? "A set of models names no directory."
            : isThere()
                ? "No file in the folder matches: includes "
                    + includes
                    + ", excludes "
                    + excludes
                    + "."
                : "There is no such folder of models.";
    return Optional.of(NothingToDo.finding(message, Optional.ofNullable(directory)));
  }
}
