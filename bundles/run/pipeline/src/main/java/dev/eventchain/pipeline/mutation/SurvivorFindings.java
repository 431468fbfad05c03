package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.Diagnostic;

/** Findings about mutants that nothing notices. */
final class SurvivorFindings {

  private SurvivorFindings() {}

  static Diagnostic of(Mutant mutant, MutantResult result) {
    String message =
        result.outcome() == MutantResult.Outcome.UNCHANGED
            ? "No scenario would tell this defect, in none of which it changes an output: "
            : "No test and no scenario notices this defect: ";
    return Diagnostic.of(
            MutationRules.MUTATION_SURVIVED, message + result.mutant() + ".", mutant.location())
        .withHint(hint(result));
  }

  private static String hint(MutantResult result) {
    String add =
        result.scenario().isPresent() && result.words().isPresent()
            ? "Nearest is '%s' in the scenario %s%s: ask for more there, or add a test to tests/%s.yaml."
                .formatted(
                    result.words().get(),
                    result.scenario().get(),
                    result.left().map(left -> ", which has " + left + " left").orElse(""),
                    result.component())
            : "%sdd a test to tests/%s.yaml, or a scenario, in which this line decides."
                .formatted(
                    result.outcome() == MutantResult.Outcome.UNNOTICED
                        ? "Outputs change, but no criterion comes nearer to failing: a"
                        : "A",
                    result.component());
    String entry = "{component: %s, mutant: %s, reason: ..., expires: ...}";
    return add
        + " If it is right, too, accept it in mutants.yaml: - "
        + entry.formatted(result.component(), quoted(result.mutant()));
  }

  private static String quoted(String text) {
    return "'" + text.replace("'", "''") + "'";
  }
}
