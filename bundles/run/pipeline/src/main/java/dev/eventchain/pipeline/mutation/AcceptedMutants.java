package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.project.DatedEntries;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Mutants that may survive, since nobody can tell them from the component, or nobody has to: the
 * file {@code mutants.yaml} of a project, a list of entries with {@code component}, {@code mutant}
 * (its id), {@code reason} and {@code expires}.
 *
 * @param entries in the order of the file
 */
record AcceptedMutants(List<Entry> entries) {

  /** An accepted mutant. */
  record Entry(
      String component, String mutant, String reason, LocalDate expires, SourceLocation location) {

    boolean isAbout(String ofComponent, String id) {
      return component.equals(ofComponent) && mutant.equals(id);
    }
  }

  /** Copies the list. */
  AcceptedMutants {
    entries = List.copyOf(entries);
  }

  /**
   * Reads the file of a project; there is none in a project that accepts no mutant.
   *
   * @throws DiagnosticException INPUT with all invalid entries
   */
  static AcceptedMutants of(ProjectFolder project) {
    Path file = project.folder().resolve(ProjectLayout.MUTANTS);
    return ProjectFolder.isAbsent(file) ? new AcceptedMutants(List.of()) : read(file);
  }

  private static AcceptedMutants read(Path file) {
    Set<String> known = new HashSet<>();
    return new AcceptedMutants(
        DatedEntries.read(file, MutationRules.MUTATION_ACCEPTED, part -> entry(part, known)));
  }

  private static Entry entry(DatedEntries.Entry part, Set<String> known) {
    String component = part.text("component");
    String mutant = part.text("mutant");
    String reason = part.text("reason");
    LocalDate expires = part.day("expires");
    if (!known.add(component + "\n" + mutant)) {
      part.refuse("mutant", "This mutant is accepted twice.");
    }
    return new Entry(component, mutant, reason, expires, part.location());
  }

  /** Returns the entry that accepts a survivor. */
  Optional<Entry> find(MutantResult result, LocalDate today) {
    return entries.stream()
        .filter(each -> each.isAbout(result.component(), result.mutant()))
        .filter(each -> !today.isAfter(each.expires()))
        .findFirst();
  }

  /**
   * Returns warnings about entries that accept nothing: there is no such mutant, it is caught, or
   * the day has passed.
   *
   * @param results those of all mutants, tried or not
   */
  List<Diagnostic> warnings(List<MutantResult> results, LocalDate today) {
    return entries.stream().flatMap(each -> warning(each, results, today).stream()).toList();
  }

  private static Optional<Diagnostic> warning(
      Entry entry, List<MutantResult> results, LocalDate today) {
    Optional<MutantResult> result =
        results.stream().filter(each -> entry.isAbout(each.component(), each.mutant())).findFirst();
    String name = "The accepted mutant '" + entry.mutant() + "' of " + entry.component();
    if (result.isEmpty()) {
      List<String> ids =
          results.stream()
              .filter(each -> each.component().equals(entry.component()))
              .map(MutantResult::mutant)
              .toList();
      return Optional.of(
          warning(name + " does not exist.", entry)
              .withHint(
                  ids.isEmpty()
                      ? "The chain executes no such component; delete the entry."
                      : NearestName.hint(entry.mutant(), ids)));
    }
    if (result.get().outcome().isCaught()) {
      return Optional.of(warning(name + " is caught.", entry).withHint("Delete the entry."));
    }
    return today.isAfter(entry.expires())
        ? Optional.of(
            warning("The acceptance of '" + entry.mutant() + "' has expired.", entry)
                .withHint("Add what catches it, or review the decision and set a new date."))
        : Optional.empty();
  }

  private static Diagnostic warning(String message, Entry entry) {
    return Diagnostic.of(MutationRules.MUTATION_ACCEPTED, message, entry.location())
        .withSeverity(Severity.WARNING);
  }
}
