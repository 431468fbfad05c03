package dev.eventchain.simulation;

import dev.eventchain.messages.Unit;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** What the software can ask of the simulated vehicle. */
enum Actuator {
  /** Position of the throttle pedal. */
  THROTTLE("1", false, "throttle pedal, 0 to 1"),
  /** Position of the brake pedal. */
  BRAKE("1", false, "brake pedal, 0 to 1; braking wins over driving"),
  /** An acceleration, which the vehicle turns into positions of its pedals. */
  ACCELERATION("m/s2", false, "acceleration, negative to brake; instead of throttle and brake"),
  /** Steering, as a part of the largest angle of the wheels. */
  STEERING("1", false, "steering, -1 (left) to 1 (right); not simulated: must stay 0"),
  /** The hand brake. */
  HAND_BRAKE("1", true, "hand brake; not simulated: must stay false"),
  /** The reverse gear. */
  REVERSE("1", true, "reverse gear; not simulated: must stay false"),
  /** Whether the software shifts the gears. */
  MANUAL_GEAR_SHIFT("1", true, "gears shifted by the software; not simulated: must stay false");

  private final String unitText;
  private final boolean truth;
  private final String meaning;

  Actuator(String unitText, boolean truth, String meaning) {
    this.unitText = unitText;
    this.truth = truth;
    this.meaning = meaning;
  }

  static Optional<Actuator> find(String id) {
    return Arrays.stream(values()).filter(each -> each.id().equals(id)).findFirst();
  }

  /** All names, in order. */
  static List<String> ids() {
    return Arrays.stream(values()).map(Actuator::id).toList();
  }

  /** The name in a bench. */
  String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  Unit unit() {
    return Unit.parse(unitText).orElseThrow();
  }

  String unitText() {
    return unitText;
  }

  /** Whether it is true or false. */
  boolean truth() {
    return truth;
  }

  /** What it is, for people. */
  String meaning() {
    return meaning;
  }

  /** Whether the vehicle cannot follow both. */
  boolean excludes(Actuator other) {
    boolean pedals = this == THROTTLE || this == BRAKE;
    boolean otherPedals = other == THROTTLE || other == BRAKE;
    return this == other
        || (this == ACCELERATION && otherPedals)
        || (other == ACCELERATION && pedals);
  }
}
