package dev.eventchain.simulation.verdict;

import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * Strength of the evidence for requirements: which standard faults of the components that satisfy a
 * requirement its criteria notice.
 *
 * @param requirements one for each requirement that a simulated component satisfies and a scenario
 *     names, in the order of their identifiers
 * @param runs the number of runs with a fault
 * @param seconds the simulated time of these runs
 * @param tried the number of faults that were tried
 * @param faults the number of all faults that may change something; more than those that were tried
 *     if the budget allowed a sample only
 */
public record Strength(
    List<Requirement> requirements, int runs, double seconds, int tried, int faults) {

  private static final double PERCENT = 100;

  /**
   * The least number of faults for a part of them to say something: that of the faults of whole
   * messages, which each output that changes has.
   */
  public static final int ENOUGH = 6;

  /** Copies the list. */
  public Strength {
    requirements = List.copyOf(requirements);
  }

  /** Returns whether the budget has kept something from being tried. */
  public boolean isSample() {
    return tried < faults;
  }

  /**
   * The strength of a requirement.
   *
   * @param id the identifier of the requirement
   * @param components the components that satisfy it
   * @param branches the branches of the data flow between them. Each begins with the component in
   *     which it ends, such as one with an output that is marked with the requirement, and goes on
   *     with those that contribute to this branch only
   * @param outputs the topics of their outputs that are marked with it; empty if none is, so that
   *     each of their outputs may be what it asks for
   * @param needed true if a criterion of any scenario notices that nothing, or always the same, is
   *     sent on one of these outputs
   * @param reactions one for each fault that was tried and changed a message in one of its
   *     scenarios
   * @param leftOut the further faults that may change one, but were not tried
   */
  public record Requirement(
      String id,
      List<String> components,
      List<List<String>> branches,
      Set<String> outputs,
      boolean needed,
      List<Reaction> reactions,
      List<LeftOut> leftOut) {

    /** Copies the lists. */
    public Requirement {
      components = List.copyOf(components);
      branches = branches.stream().map(List::copyOf).toList();
      outputs = Collections.unmodifiableSortedSet(new TreeSet<>(outputs));
      reactions = List.copyOf(reactions);
      leftOut = List.copyOf(leftOut);
    }

    /** Returns the number of noticed faults. */
    public int noticed() {
      return (int) reactions.stream().filter(Reaction::noticed).count();
    }

    /** Returns the number of faults that were tried. */
    public int faults() {
      return reactions.size();
    }

    /** Returns the number of further faults to try so that a part of them says something. */
    public int missing() {
      return Math.min(Math.max(0, ENOUGH - faults()), leftOut.size());
    }

    /** Returns the noticed part of the faults that were tried, in percent. */
    public double percent() {
      return reactions.isEmpty() ? 0 : PERCENT * noticed() / faults();
    }

    /**
     * Returns the same for the faults of the components that count for a bound: one of each branch,
     * as if one component did what these do. A design that lets more components contribute to a
     * requirement is not tested less. Faults of outputs of other requirements do not count, see
     * {@link Reaction#elsewhere}. Where outputs are marked with the requirement, and the criteria
     * notice nothing of the component of one, that component alone counts.
     */
    public Requirement counted() {
      List<Requirement> found = branches.stream().map(this::sharpest).toList();
      return found.stream()
          .filter(each -> !outputs.isEmpty() && each.noticed() == 0)
          .findFirst()
          .orElseGet(() -> of(found.stream().flatMap(it -> it.components.stream()).toList()));
    }

    /**
     * Returns the strength of the component of a branch of which the criteria notice the largest
     * part. Those that only contribute need enough faults: a single one that is noticed says
     * little.
     */
    private Requirement sharpest(List<String> branch) {
      Requirement end = of(branch.subList(0, 1));
      return branch.stream()
          .skip(1)
          .map(name -> of(List.of(name)))
          .filter(each -> each.faults() >= ENOUGH)
          .reduce(end, (one, other) -> other.percent() > one.percent() ? other : one);
    }

    private Requirement of(List<String> some) {
      return new Requirement(
          id,
          some,
          some.stream().map(List::of).toList(),
          outputs,
          needed,
          reactions.stream()
              .filter(each -> some.contains(each.component()) && !each.elsewhere())
              .toList(),
          leftOut.stream()
              .filter(each -> some.contains(each.component()) && !each.elsewhere())
              .toList());
    }

    /** Returns the faults that were not noticed. */
    public List<Reaction> unnoticed() {
      return reactions.stream().filter(each -> !each.noticed()).toList();
    }
  }

  /**
   * A fault that may change a message in the scenarios of a requirement, but was not tried.
   *
   * @param component the component with the fault
   * @param topic the topic of its output
   * @param elsewhere true if faults of this output do not count, see {@link Reaction#elsewhere}
   */
  public record LeftOut(String component, String topic, boolean elsewhere) {}

  /**
   * The reaction of a requirement's criteria to a fault.
   *
   * @param component the component with the fault
   * @param fault the fault, for users
   * @param noticed true if a criterion that holds without the fault fails with it
   * @param scenario the scenario that noticed it, or else the one that came nearest
   * @param criterion the criterion that noticed it, or came nearest; empty if none could be judged
   * @param margin the margin of that criterion with the fault; empty if it has no size
   * @param elsewhere true if the fault is of an output that is not marked with this requirement, of
   *     which another one notices faults, and this one none, while it notices some of another
   *     output
   */
  public record Reaction(
      String component,
      String fault,
      boolean noticed,
      String scenario,
      String criterion,
      Optional<Margin> margin,
      boolean elsewhere) {

    /** Returns the reaction to a fault of an output of other requirements, or of this one. */
    public Reaction withElsewhere(boolean ofOthers) {
      return new Reaction(component, fault, noticed, scenario, criterion, margin, ofOthers);
    }
  }
}
