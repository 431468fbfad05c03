package dev.eventchain.constraints;

import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;

/**
 * The result of a validation.
 *
 * @param elements the number of elements in the model
 * @param checks the invariants in the order of the rules, including those without any element in
 *     the model
 * @param diagnostics the findings about the rules and then about the model, each in the order of
 *     places
 */
public record OclResult(int elements, List<Check> checks, List<Diagnostic> diagnostics) {

  /**
   * An invariant and the number of its evaluations.
   *
   * @param evaluations the number of elements it was evaluated on; fewer than there are if it was
   *     abandoned
   */
  public record Check(OclConstraint constraint, long evaluations) {}

  /** Copies the lists. */
  public OclResult {
    checks = List.copyOf(checks);
    diagnostics = List.copyOf(diagnostics);
  }

  /** Returns the number of invariants. */
  public int constraints() {
    return checks.size();
  }

  /** Returns the number of evaluations of all invariants. */
  public long evaluations() {
    return checks.stream().mapToLong(Check::evaluations).sum();
  }
}
