package dev.eventchain.simulation.judge;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Criterion;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * A contact that would come soon after the end of a run if both went on as they then move: the ego
 * with the deceleration that it has, and what is ahead of it with its own and with its motion
 * across the road. So the run was too short to show whether there is an impact.
 *
 * @param ahead what is ahead
 * @param gap at the end of the run, in m
 * @param after time from the end of the run to the contact, in s
 * @param speed relative speed at the contact, in m/s
 */
record OpenEnd(Actor ahead, double gap, double after, double speed) {

  /**
   * Time by which a run is continued, in s: an approach that takes longer is that of a vehicle
   * which follows another one.
   */
  private static final double CONTINUED = 10.0;

  private static final double STEP = World.seconds(World.TRACE_STEP);

  /** Deceleration above which what is ahead is not what was ahead before, in m/s2. */
  private static final double LARGEST = 15.0;

  /**
   * Returns the contact that a run leaves open. Where a scenario says itself what it waits for
   * ({@code end_when}), that is its conclusion.
   */
  static Optional<OpenEnd> of(ScenarioRun run) {
    Trace trace = run.trace();
    List<Trace.State> states = trace.states();
    if (trace.isCut() || trace.impactSpeed().isPresent() || states.size() < 2 || concluded(run)) {
      return Optional.empty();
    }
    Trace.State end = trace.end();
    boolean approaches = Double.isFinite(end.timeToCollision()) && end.speed() > 0 && end.gap() > 0;
    return approaches
        ? ahead(trace).flatMap(it -> continued(trace, states.get(states.size() - 2), it))
        : Optional.empty();
  }

  /** Returns whether what the scenario waits for ended the run. */
  private static boolean concluded(ScenarioRun run) {
    return run.scenario().situation().end().isPresent()
        && run.trace().end().time() < World.nanoseconds(run.scenario().duration());
  }

  /** Returns the actor to which the gap at the end is. */
  private static Optional<Actor> ahead(Trace trace) {
    Trace.State end = trace.end();
    double time = World.seconds(end.time());
    return trace.actors().stream()
        .filter(it -> it.exists(time))
        .filter(it -> Math.abs(it.rear(time) - end.position() - end.gap()) < 1e-6)
        .findFirst();
  }

  private static Optional<OpenEnd> continued(Trace trace, Trace.State before, Actor ahead) {
    Trace.State end = trace.end();
    double interval = World.seconds(end.time() - before.time());
    double braking = Math.max(0.0, end.deceleration());
    double slowing = (before.leadSpeed() - end.leadSpeed()) / interval;
    slowing = slowing > 0.0 && slowing < LARGEST ? slowing : 0.0;
    double speed = end.speed();
    double other = end.leadSpeed();
    double gap = end.gap();
    for (int i = 1; i * STEP <= CONTINUED && speed > 0.0; i++) {
      speed = Math.max(0.0, speed - braking * STEP);
      other = other > 0.0 ? Math.max(0.0, other - slowing * STEP) : other;
      gap -= (speed - other) * STEP;
      if (gap <= 0.0 && speed > 0.0) {
        double aside = (end.pose().offset() - before.pose().offset()) / interval;
        return Optional.of(new OpenEnd(ahead, end.gap(), i * STEP, speed - other))
            .filter(it -> it.isInTheWay(trace, aside));
      }
    }
    return Optional.empty();
  }

  /**
   * Returns whether what is ahead is still in the ego's way when they would touch.
   *
   * @param aside speed of the ego across the road, in m/s
   */
  private boolean isInTheWay(Trace trace, double aside) {
    double time = World.seconds(trace.end().time());
    double across =
        ahead.across(time)
            - trace.end().pose().offset()
            + (ahead.speedAcross(time) - aside) * after;
    return Math.abs(across) < trace.shape().width() / 2 + ahead.breadth(time);
  }

  /** Returns whether a criterion that holds so far would not hold after the contact. */
  boolean concerns(Expectation criterion) {
    return criterion instanceof Criterion known
        && switch (known.kind()) {
          case NO_IMPACT, MINIMAL_GAP -> true;
          case MAXIMAL_IMPACT_SPEED -> speed > known.limit();
          default -> false;
        };
  }

  /** Returns it in words, for the outcome of a criterion. */
  String words() {
    return String.format(
        Locale.ROOT,
        "the run ended %.2f s before the ego would hit %s, as both moved then",
        after,
        ahead.name());
  }

  /** Returns the finding that an outcome is a consequence of, if a run leaves a contact open. */
  static Optional<Diagnostic.Cause> cause(Expectation criterion, Outcome outcome, ScenarioRun run) {
    return outcome.undecided() && of(run).filter(it -> it.concerns(criterion)).isPresent()
        ? Optional.of(new Diagnostic.Cause(place(run), ImpactCause.name(criterion)))
        : Optional.empty();
  }

  /** Returns the location of what ended a run. */
  private static SourceLocation place(ScenarioRun run) {
    return run.scenario().endLocation(run.trace().end().time());
  }

  /** Returns a finding on a run that leaves open a contact about which a criterion is. */
  static Optional<Diagnostic> finding(ScenarioRun run) {
    return of(run)
        .filter(
            open ->
                run.scenario().criteria().stream()
                    .anyMatch(it -> open.concerns(it) && it.judge(run.trace()).passed()))
        .map(open -> open.told(run));
  }

  private Diagnostic told(ScenarioRun run) {
    Trace.State end = run.trace().end();
    return Diagnostic.of(
            JudgeRules.SIMULATION_END_OPEN,
            String.format(
                Locale.ROOT,
                "Scenario %s ended after %.2f s while the ego came nearer to %s: %.2f m ahead, %.1f"
                    + " km/h slower. As both moved then, it would be hit %.2f s later, so that no"
                    + " impact proves nothing.",
                run.scenario().name(),
                World.seconds(end.time()),
                ahead.name(),
                gap,
                (end.speed() - end.leadSpeed()) * 3.6,
                after),
            place(run))
        .withHint(
            "Let the run last until the ego stands, is slower than what is ahead, or has passed it.");
  }
}
