package dev.eventchain.simulation.bench;

import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.sensor.Mounting;

/** Reads where a sensor is on the vehicle, and where it looks. */
final class MountingReader {

  private static final NumberRange DIRECTION = NumberRange.of(-180, 180);
  private static final NumberRange AHEAD = NumberRange.of(-30, 5);
  private static final NumberRange LEFT = NumberRange.of(-5, 5);

  private MountingReader() {}

  /** Reads the keys of a section that belong to the mounting. */
  static Mounting read(ObjectReader section) {
    return new Mounting(
        section.number("ahead_m", AHEAD),
        section.number("left_m", LEFT),
        StrictMath.toRadians(section.number("direction_deg", DIRECTION).orElse(0)));
  }
}
