package dev.eventchain.simulation.scenario;

import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;

/** Judges the end of a scenario, and the brake commands independent of the traffic. */
final class ImpactRules {

  private ImpactRules() {}

  static Outcome noImpact(Trace trace) {
    OptionalDouble impact = trace.impactSpeed();
    if (trace.minimalGap().isEmpty() && impact.isEmpty()) {
      return Outcome.nothingAhead();
    }
    return impact.isPresent()
        ? new Outcome(
            false, impactText(trace, impact.getAsDouble()), atTheEnd(trace, -impact.getAsDouble()))
        : new Outcome(true, gapText(trace) + fromBehind(trace), gapMargin(trace, 0));
  }

  private static String impactText(Trace trace, double speed) {
    return String.format(
        Locale.ROOT,
        "impact at %.1f km/h after %.2f s: %s",
        speed * 3.6,
        World.seconds(trace.end().time()),
        trace.impact());
  }

  /** Returns a note on rear impacts, which do not count as impacts of the ego. */
  private static String fromBehind(Trace trace) {
    return trace.fromBehind().stream()
        .map(
            each ->
                String.format(
                    Locale.ROOT,
                    "; %s at %.1f km/h after %.2f s",
                    each.words(),
                    each.speed() * 3.6,
                    World.seconds(each.time())))
        .collect(Collectors.joining());
  }

  /** Returns a margin of the speed. */
  private static Margin atTheEnd(Trace trace, double metresPerSecond) {
    return new Margin(metresPerSecond, "m/s", World.seconds(trace.end().time()));
  }

  private static Margin gapMargin(Trace trace, double limit) {
    Trace.State nearest =
        trace.states().stream().min(Comparator.comparingDouble(Trace.State::gap)).orElseThrow();
    return new Margin(nearest.gap() - limit, "m", World.seconds(nearest.time()));
  }

  private static String gapText(Trace trace) {
    return String.format(Locale.ROOT, "smallest gap %.2f m", trace.minimalGap().orElseThrow());
  }

  static Outcome stops(Trace trace) {
    if (trace.states().get(0).speed() == 0.0) {
      return Outcome.untested("the vehicle was stationary from the start");
    }
    if (trace.isCut() && trace.impactSpeed().isEmpty()) {
      return Outcome.untested("the run ended before its time");
    }
    double speed = trace.end().speed();
    if (trace.impactSpeed().isPresent()) {
      String text = impactText(trace, trace.impactSpeed().getAsDouble());
      return new Outcome(false, text, atTheEnd(trace, -speed));
    }
    String text = String.format(Locale.ROOT, "speed at the end %.1f km/h", speed * 3.6);
    return speed == 0.0
        ? new Outcome(true, text)
        : new Outcome(false, text, atTheEnd(trace, -speed));
  }

  static Outcome minimalGap(Trace trace, double limit) {
    OptionalDouble gap = trace.minimalGap();
    return gap.isPresent()
        ? new Outcome(gap.getAsDouble() >= limit, gapText(trace), gapMargin(trace, limit))
        : Outcome.nothingAhead();
  }

  static Outcome maximalImpactSpeed(Trace trace, double limit) {
    OptionalDouble impact = trace.impactSpeed();
    if (trace.minimalGap().isEmpty() && impact.isEmpty()) {
      return Outcome.nothingAhead();
    }
    return impact.isPresent()
        ? new Outcome(
            impact.getAsDouble() <= limit,
            impactText(trace, impact.getAsDouble()),
            atTheEnd(trace, limit - impact.getAsDouble()))
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
            String.format(
                Locale.ROOT,
                "brake %.2f commanded after %.2f s",
                first.get().pedal(),
                World.seconds(first.get().time())),
            margin(first.get(), -first.get().pedal()))
        : new Outcome(true, "never braked");
  }

  /** Returns a margin of a pedal position. */
  static Margin margin(Trace.Command command, double value) {
    return new Margin(value, "1", World.seconds(command.time()));
  }

  static Outcome brakeNormalized(Trace trace) {
    if (trace.commands().isEmpty()) {
      return Outcome.untested("no command came");
    }
    for (Trace.Command command : trace.commands()) {
      if (!(command.pedal() >= 0.0 && command.pedal() <= 1.0)) {
        return new Outcome(
            false,
            String.format(
                Locale.ROOT,
                "brake %s commanded after %.2f s",
                command.pedal(),
                World.seconds(command.time())),
            margin(command, Math.min(command.pedal(), 1.0 - command.pedal())));
      }
    }
    return new Outcome(true, String.format(Locale.ROOT, "%d commands", trace.commands().size()));
  }
}
