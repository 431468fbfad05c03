package dev.eventchain.contracts.timing;

/**
 * A number without which a bound is not known.
 *
 * @param task whose number it is
 */
public record Gap(String task, Kind kind) {

  /** Kind of the missing fact. */
  public enum Kind {
    PERIOD("its period"),
    RESPONSE("its worst-case execution time");

    private final String text;

    Kind(String text) {
      this.text = text;
    }

    /** Returns what is missing, for users. */
    public String text() {
      return text;
    }
  }
}
