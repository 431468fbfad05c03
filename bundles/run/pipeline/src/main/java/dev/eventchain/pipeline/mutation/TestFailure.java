package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * Failure of a test.
 *
 * @param component the component that is tested
 * @param ended whether a process ended, for which there may be another reason
 */
record TestFailure(String component, Diagnostic finding, boolean ended) {

  /**
   * Repeats a test, and returns whether it fails in the same way each time, and never without the
   * defect. The machine may end a process without the defect, too, which proves nothing.
   *
   * @param original runs the test with the component as it is
   * @param mutant runs it with the defect
   * @throws DiagnosticException FINDINGS, {@code mutation.unproved}: the component as it is fails
   *     although its process does not end
   */
  boolean comesAgain(
      int times, Supplier<Optional<TestFailure>> original, Supplier<Optional<TestFailure>> mutant) {
    for (int i = 0; i < times; i++) {
      Optional<TestFailure> without = original.get();
      if (without.isPresent() && !without.get().ended()) {
        throw withoutDefect(without.get().finding());
      }
      if (without.isPresent() || !mutant.get().map(this::isSame).orElse(false)) {
        return false;
      }
    }
    return true;
  }

  private boolean isSame(TestFailure other) {
    return finding.message().equals(other.finding.message());
  }

  /** Returns the error that something fails without a defect, so that mutants prove nothing. */
  static DiagnosticException withoutDefect(Diagnostic failed) {
    return new DiagnosticException(
        DiagnosticException.Reason.FINDINGS,
        Diagnostic.of(
                MutationRules.MUTATION_UNPROVED,
                "Without a defect, this fails when it is repeated: " + failed.message(),
                failed.location())
            .withHint("Find out what differs from run to run, such as a clock or random numbers."));
  }
}
