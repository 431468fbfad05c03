package dev.eventchain.agents;

import java.util.Optional;
import java.util.Random;

/**
 * A mutation of an accepted answer.
 *
 * @param name description of the mutation
 * @param outcome the required outcome of every mutant
 * @param change returns a mutant; empty if there is nothing to change
 */
record Mutation(String name, Outcome outcome, Change change) {

  /** Outcomes of a mutant, compared with its original. */
  enum Outcome {
    /** It is returned to the model, with findings. */
    REJECTED,
    /** It is accepted, and the artefact is equivalent. */
    EQUAL,
    /** It is accepted, and comparing the artefacts lists the differences. */
    VISIBLE
  }

  /** Creates a mutant. */
  @FunctionalInterface
  interface Change {
    Optional<String> of(GoodAnswer answer, Random random);
  }

  static Mutation rejected(String name, Change change) {
    return new Mutation(name, Outcome.REJECTED, change);
  }

  static Mutation equal(String name, Change change) {
    return new Mutation(name, Outcome.EQUAL, change);
  }

  static Mutation visible(String name, Change change) {
    return new Mutation(name, Outcome.VISIBLE, change);
  }
}
