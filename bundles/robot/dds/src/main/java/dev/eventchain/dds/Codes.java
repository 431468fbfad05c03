package dev.eventchain.dds;

import com.sun.jna.Pointer;

/** What functions of the library return. */
final class Codes {

  static final int TIMEOUT = -10;

  private Codes() {}

  /** A result below 0 in words. */
  static String text(Cyclone cyclone, int result) {
    Pointer text = cyclone.strretcode(result);
    return text == null ? "error " + result : text.getString(0);
  }

  /**
   * A result that is none below 0.
   *
   * @throws IllegalStateException if it is one
   */
  static int check(Cyclone cyclone, int result, String what) {
    if (result < 0) {
      throw new IllegalStateException(
          "Cyclone DDS cannot " + what + ": " + text(cyclone, result) + ".");
    }
    return result;
  }
}
