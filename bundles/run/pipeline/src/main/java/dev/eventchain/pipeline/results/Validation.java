package dev.eventchain.pipeline.results;

import java.util.List;

/**
 * The results of the constraints on a model.
 *
 * @param model the name of the model's file
 * @param constraints the number of constraints
 * @param elements the number of elements in the model
 * @param evaluations the number of evaluations
 * @param violations the number of violations
 * @param violated the qualified names of violated constraints, in order
 * @param evaluated the qualified names of constraints that were evaluated at least once
 */
public record Validation(
    String model,
    long constraints,
    long elements,
    long evaluations,
    long violations,
    List<String> violated,
    List<String> evaluated) {

  /** Copies the lists. */
  public Validation {
    violated = List.copyOf(violated);
    evaluated = List.copyOf(evaluated);
  }
}
