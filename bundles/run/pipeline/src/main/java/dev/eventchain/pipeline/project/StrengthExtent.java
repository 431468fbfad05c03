package dev.eventchain.pipeline.project;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** The extent to which the strength of requirements is measured. */
public enum StrengthExtent {
  /** All standard faults are driven. */
  WHOLE,
  /** As many as a budget of simulated time allows, which may be all. */
  SAMPLE,
  /** None. */
  OFF;

  /** Returns the word of settings and options. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns the extent of a word; empty if there is none. */
  public static Optional<StrengthExtent> of(String word) {
    return Arrays.stream(values()).filter(each -> each.word().equals(word)).findFirst();
  }
}
