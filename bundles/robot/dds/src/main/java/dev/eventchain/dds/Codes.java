package dev.eventchain.dds;

import com.sun.jna.Pointer;

/** Return codes of the library. */
final class Codes {

  static final int TIMEOUT = -10;

  private Codes() {}

  /** Returns the description of a negative return code. */
  static String text(Cyclone cyclone, int result) {
    Pointer text = cyclone.strretcode(result);
    return text == null ? "error " + result : text.getString(0);
  }

  /**
   * Returns a return code that is not negative.
   *
   * @throws IllegalStateException if it is negative
   */
  static int check(Cyclone cyclone, int result, String what) {
    if (result < 0) {
      throw new IllegalStateException(
          "Cyclone DDS cannot " + what + ": " + text(cyclone, result) + ".");
    }
    return result;
  }
}
