package dev.eventchain.simulation.judge;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.fault.Fault;
import dev.eventchain.simulation.fault.Fault.Detected;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.host.UserFiles;
import dev.eventchain.simulation.run.FaultRun;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.verdict.FaultVerdict;
import dev.eventchain.simulation.verdict.FaultVerdict.Detection;
import dev.eventchain.simulation.verdict.FaultVerdict.Deviation;
import dev.eventchain.simulation.verdict.FaultVerdict.Vehicle;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;

/** Compares a run with a fault with the one without it, and judges it. */
public final class FaultJudge {

  private final SimulatedChain chain;
  private final UserFiles files;
  private final ScenarioJudge judge;
  private final boolean worked;

  /**
   * Creates a judge.
   *
   * @param files the files with the user's code
   * @param judge the judge of the runs without faults
   * @param worked true if every component works without faults, or its finding is accepted
   */
  public FaultJudge(SimulatedChain chain, UserFiles files, ScenarioJudge judge, boolean worked) {
    this.chain = chain;
    this.files = files;
    this.judge = judge;
    this.worked = worked;
  }

  public FaultVerdict verdict(FaultRun faulty, ScenarioRun without) {
    Fault fault = faulty.fault();
    List<Detection> detections = new FaultDetections(chain, files, faulty, without).all();
    boolean effective = faulty.tookEffect();
    List<CriterionResult> expected = expected(faulty, effective, detections);
    boolean failed = expected.stream().anyMatch(each -> each.tested() && !each.passed());
    boolean tested = effective && (failed || expected.stream().allMatch(CriterionResult::tested));
    boolean held = expected.stream().allMatch(CriterionResult::passed);
    return new FaultVerdict(
        fault.name(),
        fault.scenario().name(),
        fault.words(),
        effect(faulty, effective),
        effective,
        fault.isJudged(),
        tested,
        fault.isJudged() && tested && held,
        vehicle(faulty.run().trace()),
        vehicle(without.trace()),
        deviation(faulty.run().trace(), without.trace()),
        criteria(faulty, fault.scenario().criteria()),
        expected,
        detections,
        faulty.ended(),
        fault.location());
  }

  private static String effect(FaultRun faulty, boolean effective) {
    Fault fault = faulty.fault();
    double end = World.seconds(faulty.run().trace().end().time());
    if (!effective) {
      return fault.start() >= faulty.run().trace().end().time()
          ? String.format(Locale.ROOT, "the run ended after %.2f s", end)
          : fault.kind().isAboutMessages()
              ? String.format(Locale.ROOT, "no message came on %s in that time", fault.target())
              : "there was nothing that it could change";
    }
    long count = faulty.affected();
    if (faulty.ended().isPresent()) {
      return ""; // An ended run has no log.
    }
    return switch (fault.kind()) {
      case DROP, DEAD_SENSOR -> counted(count, "message") + " did not arrive";
      case REPEAT, FLOOD -> counted(count, "message") + " arrived more than once";
      case CORRUPT ->
          counted(count, "message") + " changed; those that can no longer be decoded were lost";
      case DELAY -> counted(count, "activation") + " took longer";
      default -> "";
    };
  }

  private static String counted(long count, String what) {
    return count + " " + what + (count == 1 ? "" : "s");
  }

  private List<CriterionResult> criteria(FaultRun faulty, List<Expectation> criteria) {
    ScenarioRun run = faulty.run().with(faulty.run().scenario().with(criteria));
    if (faulty.ended().isEmpty()) {
      // Other runs of a fault have criteria at the same place: a cause would not tell which it is.
      return judge.criteria(run, worked).stream()
          .map(each -> each.withCause(Optional.empty()))
          .toList();
    }
    String why = endedEarly(faulty.ended().get());
    return criteria.stream().map(each -> untested(faulty, each, why)).toList();
  }

  private static CriterionResult untested(FaultRun faulty, Expectation criterion, String why) {
    return ScenarioJudge.result(faulty.run().scenario(), criterion, Outcome.untested(why));
  }

  /** Judges the expected criteria; they are untested if the fault had no effect. */
  private List<CriterionResult> expected(
      FaultRun faulty, boolean effective, List<Detection> detections) {
    Fault fault = faulty.fault();
    List<CriterionResult> results =
        effective
            ? new ArrayList<>(criteria(faulty, fault.expected()))
            : new ArrayList<>(
                fault.expected().stream()
                    .map(each -> untested(faulty, each, "the fault had no effect"))
                    .toList());
    fault
        .detection()
        .map(it -> detection(faulty, it, effective, detections))
        .ifPresent(results::add);
    return results;
  }

  private static String endedEarly(Diagnostic end) {
    return "the run was ended: " + end.message();
  }

  /**
   * Returns an untested detection: a limit of the simulation may have ended the run, and later
   * events are unknown.
   */
  private static CriterionResult endedEarly(Detected wanted, Diagnostic end) {
    return result(wanted, Outcome.untested(endedEarly(end)));
  }

  private static CriterionResult result(Detected wanted, Outcome outcome) {
    return JudgedCriterion.withoutSignals(text(wanted), wanted.location()).result(outcome);
  }

  private static String text(Detected wanted) {
    return wanted.within().isPresent()
        ? String.format(
            Locale.ROOT, "the fault is detected within %.2f s", wanted.within().getAsDouble())
        : "the fault is detected";
  }

  private static CriterionResult detection(
      FaultRun faulty, Detected wanted, boolean effective, List<Detection> detections) {
    if (effective && faulty.ended().isPresent()) {
      return endedEarly(wanted, faulty.ended().get());
    }
    double start = World.seconds(faulty.fault().start());
    double latest = start + wanted.within().orElse(Double.POSITIVE_INFINITY);
    Optional<Detection> first = detections.stream().findFirst();
    boolean passed =
        effective
            && first.isPresent()
            && (wanted.within().isEmpty() || first.get().time().orElse(Double.NaN) <= latest);
    String measured =
        !effective
            ? "the fault had no effect"
            : first.map(it -> measured(it, start)).orElse("nothing reported it");
    return result(wanted, new Outcome(effective, passed, measured, Optional.empty()));
  }

  private static String measured(Detection detection, double start) {
    return detection.time().isPresent()
        ? String.format(
            Locale.ROOT,
            "%s, %.2f s after its start",
            detection.words(),
            detection.time().getAsDouble() - start)
        : detection.words() + ", at an unknown time";
  }

  private static Vehicle vehicle(Trace trace) {
    OptionalDouble stopped = OptionalDouble.empty();
    List<Trace.State> states = trace.states();
    for (int i = states.size() - 1; i >= 0 && states.get(i).speed() == 0.0; i--) {
      stopped = OptionalDouble.of(World.seconds(states.get(i).time()));
    }
    return new Vehicle(
        trace.impactSpeed(),
        trace.impact(),
        stopped,
        trace.minimalGap(),
        trace.end().speed(),
        World.seconds(trace.end().time()));
  }

  /**
   * Returns the deviation while both runs last; a vehicle at standstill at the end of the shorter
   * run counts as remaining there.
   */
  private static Deviation deviation(Trace faulty, Trace without) {
    Deviation largest = new Deviation(0, 0);
    boolean stands = without.end().speed() == 0.0 && without.impactSpeed().isEmpty();
    for (Trace.State state : faulty.states()) {
      if (state.time() <= without.end().time() || stands) {
        Trace.State other = without.stateAt(state.time());
        double distance =
            Math.hypot(
                state.position() - other.position(), state.pose().offset() - other.pose().offset());
        if (other.time() <= state.time() && distance > largest.distance()) {
          largest = new Deviation(distance, World.seconds(state.time()));
        }
      }
    }
    return largest;
  }
}
