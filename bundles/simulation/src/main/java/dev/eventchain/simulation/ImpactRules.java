package dev.eventchain.simulation;

import static dev.eventchain.simulation.Criterion.format;

import dev.eventchain.simulation.Criterion.Outcome;
import java.util.Optional;
import java.util.OptionalDouble;

/** Judges how a scenario ended, and the brake commands whatever the traffic. */
final class ImpactRules {

  private ImpactRules() {}

  /** Without a vehicle in the path there is nothing to hit and no gap to keep. */
  private static Outcome nothingAhead() {
    return Outcome.untested("nothing ahead");
  }

  static Outcome noImpact(Trace trace) {
    if (trace.minimalGap().isEmpty()) {
      return nothingAhead();
    }
    OptionalDouble impact = trace.impactSpeed();
    return impact.isPresent()
        ? new Outcome(
            false,
            format(
                "impact at %.1f km/h after %.2f s",
                impact.getAsDouble() * 3.6, World.seconds(trace.end().time())))
        : new Outcome(true, gapText(trace));
  }

  private static String gapText(Trace trace) {
    return format("smallest gap %.2f m", trace.minimalGap().orElseThrow());
  }

  static Outcome stops(Trace trace) {
    if (trace.states().get(0).speed() == 0.0) {
      return Outcome.untested("the vehicle stood from the start");
    }
    double speed = trace.end().speed();
    boolean stands = speed == 0.0 && trace.impactSpeed().isEmpty();
    return new Outcome(stands, format("speed at the end %.1f km/h", speed * 3.6));
  }

  static Outcome minimalGap(Trace trace, double limit) {
    OptionalDouble gap = trace.minimalGap();
    return gap.isPresent()
        ? new Outcome(gap.getAsDouble() >= limit, gapText(trace))
        : nothingAhead();
  }

  static Outcome maximalImpactSpeed(Trace trace, double limit) {
    if (trace.minimalGap().isEmpty()) {
      return nothingAhead();
    }
    OptionalDouble impact = trace.impactSpeed();
    return impact.isPresent()
        ? new Outcome(
            impact.getAsDouble() <= limit,
            format("impact at %.1f km/h", impact.getAsDouble() * 3.6))
        : new Outcome(true, "no impact");
  }

  static Outcome neverBrakes(Trace trace) {
    if (trace.commands().isEmpty()) {
      return Outcome.untested("no command came");
    }
    Optional<Trace.Command> first = trace.firstBraking();
    return first.isPresent()
        ? new Outcome(
            false,
            format(
                "brake %.2f commanded after %.2f s",
                first.get().pedal(), World.seconds(first.get().time())))
        : new Outcome(true, "never braked");
  }

  static Outcome brakeNormalized(Trace trace) {
    if (trace.commands().isEmpty()) {
      return Outcome.untested("no command came");
    }
    for (Trace.Command command : trace.commands()) {
      if (!(command.pedal() >= 0.0 && command.pedal() <= 1.0)) {
        return new Outcome(
            false,
            format(
                "brake %s commanded after %.2f s", command.pedal(), World.seconds(command.time())));
      }
    }
    return new Outcome(true, format("%d commands", trace.commands().size()));
  }
}
