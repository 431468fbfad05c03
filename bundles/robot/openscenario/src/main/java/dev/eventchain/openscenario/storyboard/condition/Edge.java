package dev.eventchain.openscenario.storyboard.condition;

/** Kind of change of an expression from the step before at which a condition looks. */
enum Edge {
  NONE,
  RISING,
  FALLING,
  RISING_OR_FALLING;

  static Edge of(String text) {
    return switch (text) {
      case "rising" -> RISING;
      case "falling" -> FALLING;
      case "risingOrFalling" -> RISING_OR_FALLING;
      default -> NONE;
    };
  }

  /**
   * Returns whether the edge is there.
   *
   * @param before null if there was no step before, after which there is no edge
   */
  boolean holds(Boolean before, boolean now) {
    if (this == NONE) {
      return now;
    }
    return before != null
        && before != now
        && (this == RISING_OR_FALLING || now == (this == RISING));
  }
}
