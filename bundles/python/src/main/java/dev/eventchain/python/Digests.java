package dev.eventchain.python;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** Short names for contents. */
final class Digests {

  private static final int KEY_LENGTH = 12;

  private Digests() {}

  static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("every Java has SHA-256", e);
    }
  }

  /** The first 12 hexadecimal digits. */
  static String key(MessageDigest digest) {
    return HexFormat.of().formatHex(digest.digest()).substring(0, KEY_LENGTH);
  }
}
