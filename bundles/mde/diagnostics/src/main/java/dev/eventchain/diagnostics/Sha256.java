package dev.eventchain.diagnostics;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** SHA-256 of the added content, which identifies it in reports, keys and records. */
public final class Sha256 {

  private static final int ABBREVIATED = 12;

  private final MessageDigest digest;

  /** Starts an empty hash. */
  public Sha256() {
    try {
      digest = MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java platform has SHA-256", e);
    }
  }

  /** Returns the hash of a text in UTF-8. */
  public static Sha256 of(String text) {
    return new Sha256().add(text);
  }

  /** Adds bytes. Callers that add several values must delimit them. */
  public Sha256 add(byte[] bytes) {
    digest.update(bytes);
    return this;
  }

  /** Adds a text in UTF-8. */
  public Sha256 add(String text) {
    return add(text.getBytes(StandardCharsets.UTF_8));
  }

  /** Returns the 32 bytes of the hash and resets it. */
  public byte[] bytes() {
    return digest.digest();
  }

  /** Returns the 64 lower-case hexadecimal digits of the hash and resets it. */
  public String hex() {
    return HexFormat.of().formatHex(bytes());
  }

  /**
   * Returns the first 12 hexadecimal digits, for names of files and folders, and resets the hash.
   */
  public String abbreviated() {
    return hex().substring(0, ABBREVIATED);
  }
}
