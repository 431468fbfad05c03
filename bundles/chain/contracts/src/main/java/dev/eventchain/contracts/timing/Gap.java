package dev.eventchain.contracts.timing;

/**
 * A number without which a bound is not known.
 *
 * @param task whose number it is
 */
public record Gap(String task, Kind kind) {

  /** Kind of the missing fact. */
  public enum Kind {
    PERIOD,
    /** The worst-case execution time. */
    RESPONSE
  }
}
