package dev.eventchain.simulation.world;

import dev.eventchain.messages.Unit;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** Actuators of the simulated vehicle. */
public enum Actuator {
  /** Position of the throttle pedal. */
  THROTTLE("1", false, "throttle pedal, 0 to 1"),
  /** Position of the brake pedal. */
  BRAKE("1", false, "brake pedal, 0 to 1; braking wins over driving"),
  /** An acceleration, which the vehicle turns into positions of its pedals. */
  ACCELERATION("m/s2", false, "acceleration, negative to brake; instead of throttle and brake"),
  /** Steering, as a fraction of the largest angle of the front wheels. */
  STEERING("1", false, "steering, -1 (left) to 1 (right) of the largest angle"),
  /** The angle of the front wheels. */
  STEERING_ANGLE("rad", false, "angle of the front wheels, left is positive; instead of steering"),
  /** The hand brake. */
  HAND_BRAKE("1", true, "hand brake"),
  /** The reverse gear, which engages at standstill. */
  REVERSE("1", true, "reverse gear; engages at standstill"),
  /** The gear. */
  GEAR("1", false, "gear: -1 backwards, 0 neutral, 1 and more forwards; instead of reverse"),
  /** A speed, which the vehicle keeps by itself, as mobile robots do. */
  SPEED("m/s", false, "speed, negative backwards; instead of pedals, acceleration and gear"),
  /** A rate of turning, which the vehicle keeps by itself, beside a speed. */
  YAW_RATE("rad/s", false, "yaw rate, left is positive; instead of steering, beside speed"),
  /** Manual mode, in which the software shifts the gears. */
  MANUAL_GEAR_SHIFT("1", true, "gears shifted by the software; not simulated: must stay false");

  private final String unitText;
  private final boolean truth;
  private final String meaning;

  Actuator(String unitText, boolean truth, String meaning) {
    this.unitText = unitText;
    this.truth = truth;
    this.meaning = meaning;
  }

  public static Optional<Actuator> find(String id) {
    return Arrays.stream(values()).filter(each -> each.id().equals(id)).findFirst();
  }

  /** Returns all names, in order. */
  public static List<String> ids() {
    return Arrays.stream(values()).map(Actuator::id).toList();
  }

  /** Returns the name in a bench. */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  public Unit unit() {
    return Unit.parse(unitText).orElseThrow();
  }

  public String unitText() {
    return unitText;
  }

  /** Returns whether it is Boolean. */
  public boolean truth() {
    return truth;
  }

  /** Returns the description for users. */
  public String meaning() {
    return meaning;
  }

  /** Returns whether the vehicle cannot follow both. */
  public boolean excludes(Actuator other) {
    return this == other || demands().stream().anyMatch(other.demands()::contains);
  }

  /**
   * Returns its degrees of freedom: of two actuators with a common one, only one can be followed.
   */
  private Set<String> demands() {
    return switch (this) {
      case THROTTLE -> Set.of("throttle");
      case BRAKE -> Set.of("brake");
      case ACCELERATION -> Set.of("throttle", "brake");
      case SPEED -> Set.of("throttle", "brake", "gear", "hand brake");
      case STEERING, STEERING_ANGLE, YAW_RATE -> Set.of("wheels");
      case HAND_BRAKE -> Set.of("hand brake");
      case REVERSE, GEAR -> Set.of("gear");
      case MANUAL_GEAR_SHIFT -> Set.of("shift");
    };
  }
}
