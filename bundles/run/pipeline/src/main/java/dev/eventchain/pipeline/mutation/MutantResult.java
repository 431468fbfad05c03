package dev.eventchain.pipeline.mutation;

import java.util.Optional;

/**
 * Test or scenario that noticed a mutant, or came nearest.
 *
 * @param component the component's name
 * @param mutant the mutant's id
 * @param line its place in the component's file, from 1
 * @param column from 1
 * @param outcome whether and how it was noticed
 * @param scenario the scenario that noticed it or came nearest, if one did
 * @param words the test or criterion that noticed it or came nearest, or what the component did
 * @param left the distance of the nearest criterion from failing, with its unit, if it has a size
 */
record MutantResult(
    String component,
    String mutant,
    int line,
    int column,
    Outcome outcome,
    Optional<String> scenario,
    Optional<String> words,
    Optional<String> left) {

  /** Way in which a mutant was noticed, if it was. */
  enum Outcome {
    /** Not tried with the current files. */
    NOT_TRIED(false),
    /** A test of the component fails. */
    TEST(true),
    /** A criterion of a scenario fails. */
    CRITERION(true),
    /** A criterion of a scenario can no longer be judged. */
    UNTESTED(true),
    /** The component does not work in a scenario. */
    RAISED(true),
    /** The process of the component or of the nodes ends, each time, and not without the defect. */
    ENDED(true),
    /** A process ended, but not each time or without the defect, too: nothing is known. */
    UNPROVED(false),
    /** Nothing noticed it, although outputs changed. */
    UNNOTICED(false),
    /** Nothing noticed it, and no output changed in any scenario. */
    UNCHANGED(false);

    private final boolean caught;

    Outcome(boolean caught) {
      this.caught = caught;
    }

    boolean isCaught() {
      return caught;
    }
  }

  boolean survives() {
    return outcome == Outcome.UNNOTICED || outcome == Outcome.UNCHANGED;
  }

  static MutantResult of(
      Mutant mutant,
      Outcome outcome,
      Optional<String> scenario,
      Optional<String> words,
      Optional<String> left) {
    return new MutantResult(
        mutant.component(),
        mutant.id(),
        mutant.defect().line(),
        mutant.defect().column(),
        outcome,
        scenario,
        words,
        left);
  }

  /** Returns the result of a mutant that was not tried. */
  static MutantResult notTried(Mutant mutant) {
    return of(mutant, Outcome.NOT_TRIED, Optional.empty(), Optional.empty(), Optional.empty());
  }
}
