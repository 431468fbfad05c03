package dev.eventchain.simulation.verdict;

import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import java.util.Optional;

/**
 * The reaction of scenarios to a variant of a component.
 *
 * @param kind whether and how they noticed it
 * @param scenario the scenario that noticed it, or else the one that came nearest; empty if none
 *     came nearer to failing than without it
 * @param words the criterion that noticed it or came nearest, or what the variant did instead;
 *     empty if there is none
 * @param margin what is left of that criterion's distance from failing; empty if it has no size
 */
public record VariantReaction(Kind kind, String scenario, String words, Optional<Margin> margin) {

  /** Way in which a variant was noticed, if it was. */
  public enum Kind {
    /** A criterion that holds without it fails. */
    CRITERION,
    /** A criterion that holds without it can no longer be judged, so that a run is incomplete. */
    UNTESTED,
    /** The component does not work. */
    RAISED,
    /**
     * The process of the component or of the nodes ends, in each of several runs, and not with the
     * component as it is.
     */
    ENDED,
    /**
     * A process ended, but not when that was repeated, or it does with the components as they are,
     * too, so that nothing is known.
     */
    UNPROVED,
    /** All criteria hold, although outputs changed. */
    UNNOTICED,
    /** All criteria hold, and no output changed in any scenario. */
    UNCHANGED;

    /** Returns whether the scenarios noticed the variant. */
    public boolean isNoticed() {
      return this != UNNOTICED && this != UNCHANGED && this != UNPROVED;
    }
  }
}
