package dev.eventchain.pipeline;

import java.time.Clock;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.Map;

/**
 * The date for which suppressions are evaluated. {@code SOURCE_DATE_EPOCH}, in seconds, replaces
 * the clock, as in other reproducible builds.
 */
public final class Today {

  private final String epoch;
  private final Clock clock;

  private Today(String epoch, Clock clock) {
    this.epoch = epoch;
    this.clock = clock;
  }

  /**
   * Returns an instance that reads the environment on demand.
   *
   * @param environment the environment, possibly with {@code SOURCE_DATE_EPOCH}
   */
  public static Today of(Map<String, String> environment, Clock clock) {
    return new Today(environment.getOrDefault("SOURCE_DATE_EPOCH", ""), clock);
  }

  /**
   * Returns the day, in UTC.
   *
   * @throws IllegalArgumentException if the environment's value is not a number of seconds
   */
  public LocalDate date() {
    if (epoch.isEmpty()) {
      return LocalDate.now(clock.withZone(ZoneOffset.UTC));
    }
    if (!epoch.matches("[0-9]{1,11}")) {
      throw new IllegalArgumentException(
          "SOURCE_DATE_EPOCH is '" + epoch + "', which is not a number of seconds");
    }
    return LocalDate.ofInstant(Instant.ofEpochSecond(Long.parseLong(epoch)), ZoneOffset.UTC);
  }
}
