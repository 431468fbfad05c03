package dev.eventchain.simulation.scenario;

import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * Compares brake commands with the true time to collision (TTC). A command lags behind the sensors,
 * so it is compared with the true values within the reaction time before it: it is wrong if no
 * moment of that time justifies it. At walking speed and below, neither braking nor coasting is
 * wrong, since the difference of two nearly equal distances is meaningless.
 */
final class BrakingRules {

  /** Minimum ego speed for the comparison of commands with the TTC, in m/s. */
  private static final double SLOWEST = 1.5;

  /** Maximum time without any control command, in ns. */
  private static final long LONGEST_SILENCE = 1_000_000_000L;

  private BrakingRules() {}

  /**
   * Judges that there is no such command, unless the TTC was below the limit within the reaction
   * time before it.
   */
  static Outcome forbidden(Trace trace, Criterion criterion, Predicate<Trace.Command> kind) {
    double limit = criterion.limit() + criterion.tolerances().timeToCollision();
    Optional<Margin> least = Optional.empty();
    for (Trace.Command command : trace.commands()) {
      if (kind.test(command)) {
        Margin margin =
            seconds(justification(trace, command.time(), criterion, limit), command.time());
        if (!(margin.value() > 0.0)) {
          return new Outcome(false, wrong(trace, command), margin);
        }
        least = smaller(least, margin);
      }
    }
    boolean tested =
        !trace.commands().isEmpty()
            && trace.states().stream()
                .anyMatch(s -> s.timeToCollision() >= limit && s.speed() >= SLOWEST);
    return tested
        ? kept(firstText(trace, kind), least)
        : Outcome.untested(
            String.format(Locale.ROOT, "TTC was never %.1f s or more", criterion.limit()));
  }

  private static String wrong(Trace trace, Trace.Command command) {
    return String.format(
        Locale.ROOT,
        "brake %.2f commanded after %.2f s at TTC %s",
        command.pedal(),
        World.seconds(command.time()),
        seconds(trace.stateAt(command.time()).timeToCollision()));
  }

  private static Margin seconds(double value, long time) {
    return new Margin(value, "s", World.seconds(time));
  }

  private static Optional<Margin> smaller(Optional<Margin> least, Margin margin) {
    return least.filter(it -> it.value() <= margin.value()).or(() -> Optional.of(margin));
  }

  /** Returns a passed outcome; without a command, or if the ego was too slow, it has no margin. */
  private static Outcome kept(String text, Optional<Margin> margin) {
    return new Outcome(true, true, text, margin.filter(it -> Double.isFinite(it.value())));
  }

  /**
   * Returns by how much the TTC was below the limit within the reaction time, in s; at most 0 if it
   * never was.
   */
  private static double justification(Trace trace, long time, Criterion criterion, double limit) {
    double most = Double.NEGATIVE_INFINITY;
    long start = Math.max(0, time - World.nanoseconds(criterion.tolerances().reaction()));
    for (long at = start; at <= time; at += World.TRACE_STEP) {
      Trace.State state = trace.stateAt(at);
      if (state.speed() < SLOWEST) {
        return Double.POSITIVE_INFINITY;
      }
      most = Math.max(most, limit - state.timeToCollision());
    }
    return most;
  }

  /**
   * Judges that a pedal position is in force whenever the TTC has been below the limit for the
   * reaction time.
   *
   * @param needed the smallest sufficient position, or 0 if any position above it is
   */
  static Outcome demanded(
      Trace trace, Criterion criterion, Predicate<Trace.Command> kind, double needed) {
    double limit = criterion.limit() - criterion.tolerances().timeToCollision();
    long reaction = World.nanoseconds(criterion.tolerances().reaction());
    long since = -1;
    int next = 0;
    Optional<Margin> least = Optional.empty();
    Trace.Command inForce = new Trace.Command(0, 0.0, 0.0, 0.0);
    List<Trace.Command> commands = trace.commands();
    for (Trace.State state : trace.states()) {
      while (next < commands.size() && commands.get(next).time() <= state.time()) {
        inForce = commands.get(next++);
      }
      boolean below = state.timeToCollision() < limit && state.speed() >= SLOWEST;
      since = below ? (since < 0 ? state.time() : since) : -1;
      if (since >= 0 && state.time() - since >= reaction) {
        Margin margin = new Margin(inForce.pedal() - needed, "1", World.seconds(state.time()));
        if (!kind.test(inForce)) {
          return new Outcome(false, tooLittle(inForce, state), margin);
        }
        least = smaller(least, margin);
      }
    }
    return least.isPresent()
        ? kept(firstText(trace, kind), least)
        : Outcome.untested(
            String.format(
                Locale.ROOT, "TTC was never below %.1f s long enough", criterion.limit()));
  }

  private static String tooLittle(Trace.Command inForce, Trace.State state) {
    return String.format(
        Locale.ROOT,
        "only brake %.2f after %.2f s at TTC %s",
        inForce.pedal(),
        World.seconds(state.time()),
        seconds(state.timeToCollision()));
  }

  static Outcome commandsArrive(Trace trace) {
    List<Long> times = new ArrayList<>(List.of(0L));
    trace.commands().forEach(command -> times.add(command.time()));
    times.add(trace.end().time());
    long longest = 0;
    long from = 0;
    for (int i = 1; i < times.size() && longest <= LONGEST_SILENCE; i++) {
      long silence = times.get(i) - times.get(i - 1);
      from = silence > longest ? times.get(i - 1) : from;
      longest = Math.max(longest, silence);
    }
    Margin margin = seconds(World.seconds(LONGEST_SILENCE - longest), from);
    return longest > LONGEST_SILENCE || trace.commands().isEmpty()
        ? new Outcome(
            false,
            String.format(Locale.ROOT, "no command after %.2f s", World.seconds(from)),
            margin)
        : new Outcome(
            true, String.format(Locale.ROOT, "%d commands", trace.commands().size()), margin);
  }

  private static String firstText(Trace trace, Predicate<Trace.Command> kind) {
    return trace.commands().stream()
        .filter(kind)
        .findFirst()
        .map(
            command ->
                String.format(
                    Locale.ROOT,
                    "first after %.2f s at TTC %s",
                    World.seconds(command.time()),
                    seconds(trace.stateAt(command.time()).timeToCollision())))
        .orElse("never");
  }

  private static String seconds(double value) {
    return Double.isFinite(value) ? String.format(Locale.ROOT, "%.2f s", value) : "infinity";
  }
}
