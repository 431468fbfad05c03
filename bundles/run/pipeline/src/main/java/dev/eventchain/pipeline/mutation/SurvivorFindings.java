package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;

/** Findings about mutants that nothing notices, or of which nothing is known. */
final class SurvivorFindings {

  private SurvivorFindings() {}

  static Diagnostic of(Mutant mutant, MutantResult result) {
    String message =
        result.outcome() == MutantResult.Outcome.UNCHANGED
            ? "No scenario would tell this defect, in none of which it changes an output: "
            : "No test and no scenario notices this defect: ";
    return Diagnostic.of(
            MutationRules.MUTATION_SURVIVED, message + result.mutant() + ".", mutant.location())
        .withHint(hint(mutant, result));
  }

  static Diagnostic unproved(Mutant mutant, MutantResult result) {
    return Diagnostic.of(
            MutationRules.MUTATION_UNPROVED,
            "Nothing is known about this defect, since a process ended, and not each time or without"
                + " the defect, too ("
                + result.words().orElse("")
                + "): "
                + result.mutant()
                + ".",
            mutant.location())
        .withHint(
            "Run the command again. If that stays, look for what differs from run to run, such as"
                + " the memory of this machine.");
  }

  /** Returns the finding that a process ends without a defect, which says where. */
  static Diagnostic ofOriginal(Diagnostic end) {
    return Diagnostic.of(
            MutationRules.MUTATION_UNPROVED,
            "Without a defect, a process ends, too, so that this tells nothing about mutants: "
                + end.message(),
            end.location())
        .withSeverity(Severity.WARNING)
        .withHint(
            "Look for what ends it: a limit of this machine's memory, os._exit, or native code that"
                + " crashes. What others notice counts; run the command again for the rest.");
  }

  private static String hint(Mutant mutant, MutantResult result) {
    boolean hosted = mutant.tested().isEmpty();
    String test = "a test to tests/" + mutant.tested().orElse("") + ".yaml";
    String add =
        result.scenario().isPresent() && result.words().isPresent()
            ? "Nearest is '%s' in the scenario %s%s: ask for more there, or add %s."
                .formatted(
                    result.words().get(),
                    result.scenario().get(),
                    result.left().map(left -> ", which has " + left + " left").orElse(""),
                    hosted ? "a scenario" : test)
            : "%sdd %sa scenario, in which this line decides."
                .formatted(
                    result.outcome() == MutantResult.Outcome.UNNOTICED
                        ? "Outputs change, but no criterion comes nearer to failing: a"
                        : "A",
                    hosted ? "" : test + ", or ");
    String entry = "{component: %s, mutant: %s, reason: ..., expires: ...}";
    return add
        + " If it is right, too, accept it in mutants.yaml: - "
        + entry.formatted(result.component(), quoted(result.mutant()));
  }

  private static String quoted(String text) {
    return "'" + text.replace("'", "''") + "'";
  }
}
