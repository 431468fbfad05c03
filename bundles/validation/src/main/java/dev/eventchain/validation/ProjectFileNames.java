package dev.eventchain.validation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Files of a project that would be read if they had another name. Most files of a project may be
 * missing, so a misspelt one would silently count as none: no constraint, no scenario.
 */
final class ProjectFileNames {

  /** What is read by its name, relative to the project. */
  private static final List<String> KNOWN =
      List.of(
          "bench.yaml",
          "constraints.ocl",
          "design-rules.md",
          "eventchain-suppressions.yaml",
          "model",
          "model/chain.xmi",
          "recordings",
          "requirements.md",
          "scenarios",
          "software-base",
          "software-base/components.json",
          "software-base/msg",
          "software-base/signals.json",
          "tests");

  private ProjectFileNames() {}

  /**
   * Refuses files and folders whose names differ from known ones in case alone.
   *
   * @throws DiagnosticException INPUT with each of them ({@code project.file.misnamed})
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
        .findFirst()
        .map(
            entry ->
                Diagnostic.error(
                        "project.file.misnamed",
                        "'%s' is not read: its name has to be '%s', in this case."
                            .formatted(entry.getFileName(), name),
                        SourceLocation.of(entry))
                    .withHint("Rename it to '" + name + "'."));
  }

  /**
   * A warning for each OCL document next to {@code eventchain.yaml} that is not read.
   *
   * @param read the documents that are read
   */
  static List<Diagnostic> unreadConstraints(Path folder, Collection<Path> read) {
    Set<Path> known =
        read.stream().map(file -> file.toAbsolutePath().normalize()).collect(Collectors.toSet());
    return entries(folder).stream()
        .filter(file -> file.getFileName().toString().endsWith(".ocl"))
        .filter(file -> !known.contains(file.toAbsolutePath().normalize()))
        .map(
            file ->
                Diagnostic.warning(
                        "project.constraints.unread",
                        "The constraints in this file are not evaluated: a project's own are in constraints.ocl.",
                        SourceLocation.of(file))
                    .withHint(
                        "Write import '%s' into constraints.ocl, or move the file to another folder."
                            .formatted(file.getFileName())))
        .toList();
  }

  /** Sorted; none of a folder that may not be listed, whose files are found unreadable later. */
  private static Set<Path> entries(Path folder) {
    try (Stream<Path> entries = Files.list(folder)) {
      return entries.collect(Collectors.toCollection(TreeSet::new));
    } catch (IOException e) {
      return Set.of();
    }
  }
}
