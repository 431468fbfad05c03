package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;

/**
 * What a validation found.
 *
 * @param constraints how many invariants there were to evaluate
 * @param elements how many elements the model has
 * @param evaluations how often an invariant was evaluated on an element
 * @param diagnostics the findings about the rules and then about the model, each in the order of
 *     places
 */
public record OclResult(
    int constraints, int elements, long evaluations, List<Diagnostic> diagnostics) {

  /** Keeps the diagnostics from changing. */
  public OclResult {
    diagnostics = List.copyOf(diagnostics);
  }
}
