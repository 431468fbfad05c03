package dev.eventchain.agents;

import java.util.Optional;
import java.util.Random;

/**
 * A way to change a good answer.
 *
 * @param name what it does, in words
 * @param outcome what must come of every answer that it makes
 * @param change makes a changed answer; nothing where it has nothing to change
 */
record Mutation(String name, Outcome outcome, Change change) {

  /** What comes of an answer, in comparison with the one that it was made of. */
  enum Outcome {
    /** It goes back to the model, with findings. */
    REJECTED,
    /** It is accepted, and the artefact says the same. */
    EQUAL,
    /** It is accepted, and comparing the artefacts lists what is different. */
    VISIBLE
  }

  /** Makes a changed answer. */
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
