package dev.eventchain.simulation.judge;

import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Criterion;
import dev.eventchain.simulation.scenario.CriterionKind;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.FormulaCriterion;
import dev.eventchain.simulation.world.Trace;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.WeakHashMap;

/**
 * Decides whether a criterion that holds says anything about the software.
 *
 * <ul>
 *   <li>A formula on what components write must not hold whatever they write.
 *   <li>A criterion on how the vehicle moves must not hold in the same scenario without what the
 *       software demands. One that only limits it counts if the software noticeably moved the
 *       vehicle, too.
 *   <li>What forbids something, and so holds for software that does nothing, needs a counterpart:
 *       somewhere in the simulation the same output does something, or another criterion depends on
 *       the components that write it.
 * </ul>
 *
 * <p>Several threads may ask about different runs.
 */
final class Evidence {

  private final SimulatedChain chain;
  private final List<ScenarioRun> runs;
  private final boolean complete;
  private final SoftwareOutputs outputs;

  /**
   * By the identity of traces; thousands of variants are judged, and each is forgotten with its
   * run.
   */
  private final Map<Trace, WithoutSoftware> without =
      Collections.synchronizedMap(new WeakHashMap<>());

  private Optional<Set<String>> proven = Optional.empty();

  /**
   * Creates the evidence of a simulation.
   *
   * @param runs all its runs without faults
   * @param complete false if other scenarios may show what the software does not do in these
   */
  Evidence(SimulatedChain chain, List<ScenarioRun> runs, boolean complete) {
    this.chain = chain;
    this.runs = runs;
    this.complete = complete;
    this.outputs = new SoftwareOutputs(chain, runs);
  }

  SoftwareOutputs outputs() {
    return outputs;
  }

  /** Dependencies of a criterion that holds. */
  private record Finding(Optional<String> lack, Set<String> idle, Set<String> dependsOn) {

    static Finding none(String why) {
      return new Finding(Optional.of(why), Set.of(), Set.of());
    }

    static Finding of(Set<String> outputs) {
      return new Finding(Optional.empty(), Set.of(), outputs);
    }

    static Finding forbidden(Set<String> idle) {
      return new Finding(Optional.empty(), idle, Set.of());
    }
  }

  /** Returns the outcome of a criterion that holds: untested if that is no evidence. */
  Optional<Outcome> lackOf(Expectation criterion, ScenarioRun run) {
    if (criterion.isOfEveryScenario()) {
      return Optional.empty();
    }
    Finding finding = find(criterion, run);
    if (finding.lack().isPresent()) {
      return finding.lack().map(Outcome::untested);
    }
    if (!complete
        || finding.idle().isEmpty()
        || proven().containsAll(outputs.writers(finding.idle()))) {
      return Optional.empty();
    }
    return Optional.of(
        Outcome.untested(
            "it holds for software that does nothing, and in no scenario "
                + String.join(" or ", finding.idle())
                + " is anything but 0 or false"));
  }

  /**
   * Returns the outcome of a criterion; one on impacts is tested although nothing came into the
   * ego's way, if something does without the software: who stops before a turn across the way of an
   * oncoming vehicle never has it ahead.
   */
  Outcome withAvoided(Expectation criterion, ScenarioRun run, Outcome outcome) {
    boolean avoided =
        criterion instanceof Criterion named
            && named.limitsImpacts()
            && outcome.lack() == Outcome.Lack.NOTHING_AHEAD
            && without(run).traces().stream().anyMatch(it -> it.impactSpeed().isPresent());
    return avoided ? new Outcome(true, "no impact, but one without the software") : outcome;
  }

  private Finding find(Expectation criterion, ScenarioRun run) {
    if (criterion instanceof FormulaCriterion formula) {
      return find(formula, run);
    }
    return criterion instanceof Criterion named ? find(named, run) : Finding.of(Set.of());
  }

  private Finding find(Criterion criterion, ScenarioRun run) {
    Set<String> brake = Set.of("brake");
    return switch (criterion.kind()) {
      case NO_IMPACT, STOPS, MINIMAL_GAP, MAXIMAL_IMPACT_SPEED ->
          without(run).traces().stream().allMatch(trace -> criterion.judge(trace).passed())
              ? Finding.none(notMoved(run))
              : Finding.of(commands());
      case NEVER_BRAKES, NO_BRAKE_AT_TTC, NO_FULL_BRAKE_AT_TTC -> {
        boolean full = criterion.kind() == CriterionKind.NO_FULL_BRAKE_AT_TTC;
        yield outputs.everCommanded(full ? Trace.Command::brakesFully : Trace.Command::brakes)
            ? Finding.of(brake)
            : Finding.forbidden(brake);
      }
      default -> Finding.of(brake);
    };
  }

  private static Set<String> commands() {
    return Set.of("brake", "throttle", "steering");
  }

  private Finding find(FormulaCriterion formula, ScenarioRun run) {
    Set<String> written = outputs.among(formula.signals());
    if (!written.isEmpty() && formula.holds(run.trace().without(written))) {
      return Finding.none("it holds whatever is in " + String.join(" and ", written));
    }
    Set<String> active = outputs.active(written);
    if (!formula.holds(run.trace().without(active)) || !holdsWithout(formula, run, active)) {
      return Finding.of(written.isEmpty() ? commands() : active);
    }
    if (!written.isEmpty()) {
      Set<String> idle = new TreeSet<>(written);
      idle.removeAll(active);
      return Finding.forbidden(idle);
    }
    if (formula.isGoal() || !without(run).differs()) {
      return Finding.none(notMoved(run));
    }
    return formula.isSettled(run.trace())
        ? Finding.none("it was there from the start, and stays there without any command")
        : Finding.of(commands());
  }

  /** Returns whether a formula holds without what the software demands of the vehicle. */
  private boolean holdsWithout(FormulaCriterion formula, ScenarioRun run, Set<String> active) {
    return without(run).traces().stream()
        .allMatch(trace -> formula.holds(trace.without(active, run.trace())));
  }

  private String notMoved(ScenarioRun run) {
    return without(run).differs()
        ? "it holds without any command, too"
        : "it holds without any command, as the software did not change how the vehicle moves";
  }

  private WithoutSoftware without(ScenarioRun run) {
    return without.computeIfAbsent(run.trace(), trace -> new WithoutSoftware(run, chain));
  }

  /** Returns the components that write outputs on which criteria that hold depend. */
  private synchronized Set<String> proven() {
    if (proven.isEmpty()) {
      Set<String> found = new HashSet<>();
      for (ScenarioRun run : runs) {
        for (Expectation criterion : run.scenario().criteria()) {
          if (!criterion.isOfEveryScenario() && criterion.judge(run.trace()).passed()) {
            Finding finding = find(criterion, run);
            if (finding.lack().isEmpty() && finding.idle().isEmpty()) {
              found.addAll(outputs.writers(finding.dependsOn()));
            }
          }
        }
      }
      proven = Optional.of(found);
    }
    return proven.get();
  }
}
