package dev.eventchain.simulation;

import static dev.eventchain.simulation.Criterion.format;

import dev.eventchain.simulation.Criterion.Outcome;
import java.util.Optional;
import java.util.OptionalDouble;

/** Judges how a scenario ended, and the brake commands whatever the traffic. */
final class ImpactRules {

  private ImpactRules() {}

  static Outcome noImpact(Trace trace) {
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
    OptionalDouble gap = trace.minimalGap();
    return gap.isPresent() ? format("smallest gap %.2f m", gap.getAsDouble()) : "nothing ahead";
  }

  static Outcome stops(Trace trace) {
    double speed = trace.end().speed();
    boolean stands = speed == 0.0 && trace.impactSpeed().isEmpty();
    return new Outcome(stands, format("speed at the end %.1f km/h", speed * 3.6));
  }

  static Outcome minimalGap(Trace trace, double limit) {
    double gap = trace.minimalGap().orElse(Double.POSITIVE_INFINITY);
    return new Outcome(gap >= limit, gapText(trace));
  }

  static Outcome maximalImpactSpeed(Trace trace, double limit) {
    OptionalDouble impact = trace.impactSpeed();
    return impact.isPresent()
        ? new Outcome(
            impact.getAsDouble() <= limit,
            format("impact at %.1f km/h", impact.getAsDouble() * 3.6))
        : new Outcome(true, "no impact");
  }

  static Outcome neverBrakes(Trace trace) {
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
