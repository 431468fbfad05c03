package dev.eventchain.openscenario.storyboard.scene;

import java.time.LocalDateTime;
import java.time.OffsetDateTime;
import java.time.format.DateTimeParseException;
import java.util.Optional;

/** The environment, as far as something depends on it. */
public final class Surroundings {

  private static final double NANOS = 1e9;

  private double friction = 1;
  private Optional<LocalDateTime> timeOfDay = Optional.empty();
  private boolean clockRuns;

  /** Returns the factor on the friction of the road. */
  public double friction() {
    return friction;
  }

  public void friction(double factor) {
    friction = factor;
  }

  /** Returns the time of day; empty if the scenario says none. */
  public Optional<LocalDateTime> timeOfDay() {
    return timeOfDay;
  }

  /** Sets the time of day, and whether it goes on with the simulated time. */
  public void timeOfDay(LocalDateTime now, boolean runs) {
    timeOfDay = Optional.of(now);
    clockRuns = runs;
  }

  /** Reads a date with or without a time zone, which is dropped: all are taken as of one place. */
  public static LocalDateTime date(String text) {
    try {
      return OffsetDateTime.parse(text).toLocalDateTime();
    } catch (DateTimeParseException e) {
      return LocalDateTime.parse(text);
    }
  }

  void advance(double dt) {
    if (clockRuns) {
      timeOfDay = timeOfDay.map(now -> now.plusNanos(Math.round(dt * NANOS)));
    }
  }
}
