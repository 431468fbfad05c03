package dev.eventchain.simulation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;

/** What happened in a scenario: states at fixed distances in time, and every command. */
final class Trace {

  /**
   * A moment.
   *
   * @param time in ns
   * @param speed of the ego, in m/s
   * @param gap to the nearest vehicle in the path, in m; infinite if there is none
   * @param timeToCollision in s, from the true distance and closing speed; infinite if nothing is
   *     approached
   * @param deceleration of the ego, in m/s2
   */
  record State(long time, double speed, double gap, double timeToCollision, double deceleration) {}

  /** A command: when it was published, in ns, and the positions of the pedals as it has them. */
  record Command(long time, double pedal, double throttle) {

    boolean brakes() {
      return pedal > 0.0;
    }

    boolean brakesFully() {
      return pedal >= FULL;
    }
  }

  /** Smallest pedal position that counts as full brake; float32 cannot always hold exactly 1. */
  static final double FULL = 0.99;

  private final List<State> states = new ArrayList<>();
  private final List<Command> commands = new ArrayList<>();
  private OptionalDouble impactSpeed = OptionalDouble.empty();
  private String ignored = "";

  void state(State state) {
    states.add(state);
  }

  void command(long time, VehicleCommand command) {
    commands.add(new Command(time, command.brake(), command.throttle()));
    if (ignored.isEmpty() && !command.ignored().isEmpty()) {
      ignored =
          String.format(Locale.ROOT, "%s after %.2f s", command.ignored(), World.seconds(time));
    }
  }

  /** What the vehicle was first told and did not do, and when; empty if there was nothing. */
  String ignored() {
    return ignored;
  }

  void impact(double speed) {
    impactSpeed = OptionalDouble.of(speed);
  }

  List<State> states() {
    return Collections.unmodifiableList(states);
  }

  List<Command> commands() {
    return Collections.unmodifiableList(commands);
  }

  /** The last state. */
  State end() {
    return states.get(states.size() - 1);
  }

  /** Relative speed at the impact, in m/s. */
  OptionalDouble impactSpeed() {
    return impactSpeed;
  }

  /** Smallest gap to a vehicle in the path, in m; empty if there was none. */
  OptionalDouble minimalGap() {
    return states.stream().mapToDouble(State::gap).filter(Double::isFinite).min();
  }

  Optional<Command> firstBraking() {
    return commands.stream().filter(Command::brakes).findFirst();
  }

  /** The last state that is not later than a time. */
  State stateAt(long time) {
    int index = (int) Math.min(time / World.TRACE_STEP, states.size() - 1L);
    return states.get(index);
  }
}
