package dev.eventchain.project;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Checks for misspelt names of project files. Most files of a project are optional, so a misspelt
 * one would silently be ignored: no constraint, no scenario.
 */
public final class ProjectFileNames {

  /** Names of files that are read, relative to the project. */
  private static final List<String> KNOWN =
      List.of(
          ProjectLayout.ACCEPTED,
          ProjectLayout.BENCH,
          ProjectLayout.CONSTRAINTS,
          ProjectLayout.DESIGN_RULES,
          ProjectLayout.SUPPRESSIONS,
          "model",
          ProjectLayout.MODEL,
          ProjectLayout.MUTANTS,
          ProjectLayout.RECORDINGS,
          ProjectLayout.REQUIREMENTS,
          ProjectLayout.SCENARIOS,
          ProjectLayout.SOFTWARE_BASE,
          ProjectLayout.COMPONENTS,
          ProjectLayout.MESSAGES,
          ProjectLayout.QUESTIONS,
          ProjectLayout.SIGNALS,
          ProjectLayout.TESTS);

  /** Suffixes of the files in project folders that are read. */
  private static final List<String> READ =
      List.of(".yaml", ".json", ".xmi", ".py", ".msg", ".idl", ".srv");

  private ProjectFileNames() {}

  /**
   * Refuses files and folders whose names differ from known ones in case alone.
   *
   * @throws DiagnosticException INPUT with a finding ({@code project.file.misnamed}) for each of
   *     them
   */
  static void refuseOtherCase(Path folder) {
    List<Diagnostic> found =
        KNOWN.stream().flatMap(name -> misnamed(folder.resolve(name)).stream()).toList();
    if (!found.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, found);
    }
  }

  private static Optional<Diagnostic> misnamed(Path wanted) {
    String name = wanted.getFileName().toString();
    Path folder = wanted.resolveSibling("");
    if (!Files.isDirectory(folder) || !ProjectFolder.isAbsent(wanted)) {
      return Optional.empty();
    }
    return entries(folder).stream()
        .filter(entry -> entry.getFileName().toString().equalsIgnoreCase(name))
        .filter(entry -> !Files.isDirectory(entry) || holdsAnyToRead(entry))
        .findFirst()
        .map(
            entry ->
                Diagnostic.of(
                        ProjectRules.PROJECT_FILE_MISNAMED,
                        "'%s' is not read: its name has to be '%s', in this case."
                            .formatted(entry.getFileName(), name),
                        SourceLocation.of(entry))
                    .withHint("Rename it to '" + name + "'."));
  }

  /** Returns whether a folder has anything to read; an unrelated folder may have a similar name. */
  private static boolean holdsAnyToRead(Path folder) {
    return entries(folder).stream()
        .map(entry -> entry.getFileName().toString())
        .anyMatch(
            name ->
                READ.stream().anyMatch(name::endsWith) || Files.isDirectory(folder.resolve(name)));
  }

  /** Returns the name of a file that differs from the wanted one in case alone, if there is one. */
  static Optional<String> misspelt(Path wanted) {
    return entries(wanted.resolveSibling("")).stream()
        .map(entry -> entry.getFileName().toString())
        .filter(name -> name.equalsIgnoreCase(wanted.getFileName().toString()))
        .findFirst();
  }

  /**
   * Returns a warning for each OCL document next to {@code eventchain.yaml} that is not read.
   *
   * @param output the folder of the project's results, which may hold generated constraints
   */
  public static List<Diagnostic> unreadConstraints(ProjectFolder project, Path output) {
    Set<Path> known =
        project.constraintFiles(output).stream()
            .map(ProjectFileNames::identity)
            .collect(Collectors.toSet());
    return entries(project.folder()).stream()
        .filter(file -> file.getFileName().toString().toLowerCase(Locale.ROOT).endsWith(".ocl"))
        .filter(file -> !Files.isDirectory(file) && !known.contains(identity(file)))
        .map(
            file ->
                Diagnostic.of(
                        ProjectRules.PROJECT_CONSTRAINTS_UNREAD,
                        "The constraints in this file are not evaluated: a project's own are in constraints.ocl.",
                        SourceLocation.of(file))
                    .withHint(
                        "Write import '%s' into constraints.ocl, or move the file to another folder."
                            .formatted(file.getFileName())))
        .toList();
  }

  /** Returns the path with links resolved. */
  private static Path identity(Path file) {
    try {
      return file.toRealPath();
    } catch (IOException e) {
      return file.toAbsolutePath().normalize();
    }
  }

  /** Returns the sorted entries of a folder; none if it is unreadable, which is reported later. */
  private static Set<Path> entries(Path folder) {
    try (Stream<Path> entries = Files.list(folder)) {
      return entries.collect(Collectors.toCollection(TreeSet::new));
    } catch (IOException | UncheckedIOException e) {
      return Set.of();
    }
  }
}
