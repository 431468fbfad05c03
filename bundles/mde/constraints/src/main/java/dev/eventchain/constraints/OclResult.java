package dev.eventchain.constraints;

import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;

/**
 * What a validation found.
 *
 * @param elements how many elements the model has
 * @param checks the invariants there were to evaluate, in the order of the rules, those included
 *     that are about no element of the model
 * @param diagnostics the findings about the rules and then about the model, each in the order of
 *     places
 */
public record OclResult(int elements, List<Check> checks, List<Diagnostic> diagnostics) {

  /**
   * An invariant and what was done with it.
   *
   * @param evaluations on how many elements it was evaluated; fewer than there are if it was given
   *     up
   */
  public record Check(OclConstraint constraint, long evaluations) {}

  /** Keeps the lists from changing. */
  public OclResult {
    checks = List.copyOf(checks);
    diagnostics = List.copyOf(diagnostics);
  }

  /** How many invariants there were to evaluate. */
  public int constraints() {
    return checks.size();
  }

  /** How often an invariant was evaluated on an element. */
  public long evaluations() {
    return checks.stream().mapToLong(Check::evaluations).sum();
  }
}
