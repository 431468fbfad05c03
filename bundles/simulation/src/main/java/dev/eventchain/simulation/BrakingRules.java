package dev.eventchain.simulation;

import static dev.eventchain.simulation.Criterion.format;

import dev.eventchain.simulation.Criterion.Outcome;
import java.util.List;
import java.util.function.Predicate;

/**
 * Compares brake commands with the true time to collision (TTC). A command can only follow what the
 * sensors saw a while ago, so it is compared with the true values of the reaction time before it: a
 * command is wrong if no moment of that time justifies it. At walking speed and below, neither
 * braking nor not braking is wrong: the difference of two nearly equal distances says nothing.
 */
final class BrakingRules {

  /** Slowest ego speed at which commands are compared with the TTC, in m/s. */
  private static final double SLOWEST = 1.5;

  /** Longest time without any control command, in ns. */
  private static final long LONGEST_SILENCE = 1_000_000_000L;

  private BrakingRules() {}

  /** No such command, unless the TTC was below the limit within the reaction time before it. */
  static Outcome forbidden(Trace trace, Criterion criterion, Predicate<Trace.Command> kind) {
    double limit = criterion.limit() + criterion.tolerances().timeToCollision();
    for (Trace.Command command : trace.commands()) {
      if (kind.test(command) && unjustified(trace, command.time(), criterion, limit)) {
        return new Outcome(
            false,
            format(
                "brake %.2f commanded after %.2f s at TTC %s",
                command.pedal(),
                World.seconds(command.time()),
                seconds(trace.stateAt(command.time()).timeToCollision())));
      }
    }
    boolean tested =
        !trace.commands().isEmpty()
            && trace.states().stream()
                .anyMatch(s -> s.timeToCollision() >= limit && s.speed() >= SLOWEST);
    return tested
        ? new Outcome(true, firstText(trace, kind))
        : Outcome.untested(format("TTC was never %.1f s or more", criterion.limit()));
  }

  private static boolean unjustified(Trace trace, long time, Criterion criterion, double limit) {
    long start = Math.max(0, time - World.nanoseconds(criterion.tolerances().reaction()));
    for (long at = start; at <= time; at += World.TRACE_STEP) {
      Trace.State state = trace.stateAt(at);
      if (state.timeToCollision() < limit || state.speed() < SLOWEST) {
        return false;
      }
    }
    return true;
  }

  /** Such a command in force whenever the TTC has been below the limit for the reaction time. */
  static Outcome demanded(Trace trace, Criterion criterion, Predicate<Trace.Command> kind) {
    double limit = criterion.limit() - criterion.tolerances().timeToCollision();
    long reaction = World.nanoseconds(criterion.tolerances().reaction());
    long since = -1;
    int next = 0;
    boolean tested = false;
    Trace.Command inForce = new Trace.Command(0, 0.0, 0.0);
    List<Trace.Command> commands = trace.commands();
    for (Trace.State state : trace.states()) {
      while (next < commands.size() && commands.get(next).time() <= state.time()) {
        inForce = commands.get(next++);
      }
      boolean below = state.timeToCollision() < limit && state.speed() >= SLOWEST;
      since = below ? (since < 0 ? state.time() : since) : -1;
      boolean due = since >= 0 && state.time() - since >= reaction;
      tested |= due;
      if (due && !kind.test(inForce)) {
        return new Outcome(
            false,
            format(
                "only brake %.2f after %.2f s at TTC %s",
                inForce.pedal(), World.seconds(state.time()), seconds(state.timeToCollision())));
      }
    }
    return tested
        ? new Outcome(true, firstText(trace, kind))
        : Outcome.untested(format("TTC was never below %.1f s long enough", criterion.limit()));
  }

  static Outcome commandsArrive(Trace trace) {
    long last = 0;
    for (Trace.Command command : trace.commands()) {
      if (command.time() - last > LONGEST_SILENCE) {
        break;
      }
      last = command.time();
    }
    boolean silent = trace.end().time() - last > LONGEST_SILENCE || trace.commands().isEmpty();
    return silent
        ? new Outcome(false, format("no command after %.2f s", World.seconds(last)))
        : new Outcome(true, format("%d commands", trace.commands().size()));
  }

  private static String firstText(Trace trace, Predicate<Trace.Command> kind) {
    return trace.commands().stream()
        .filter(kind)
        .findFirst()
        .map(
            command ->
                format(
                    "first after %.2f s at TTC %s",
                    World.seconds(command.time()),
                    seconds(trace.stateAt(command.time()).timeToCollision())))
        .orElse("never");
  }

  private static String seconds(double value) {
    return Double.isFinite(value) ? format("%.2f s", value) : "infinity";
  }
}
