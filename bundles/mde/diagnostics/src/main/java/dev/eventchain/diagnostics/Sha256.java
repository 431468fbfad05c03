package dev.eventchain.diagnostics;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** The SHA-256 of what is added, by which contents are told apart in reports, keys and records. */
public final class Sha256 {

  private static final int ABBREVIATED = 12;

  private final MessageDigest digest;

  /** Of nothing yet. */
  public Sha256() {
    try {
      digest = MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java platform has SHA-256", e);
    }
  }

  /** Of a text in UTF-8. */
  public static Sha256 of(String text) {
    return new Sha256().add(text);
  }

  /** Adds bytes. Who adds several things has to keep them apart. */
  public Sha256 add(byte[] bytes) {
    digest.update(bytes);
    return this;
  }

  /** Adds a text in UTF-8. */
  public Sha256 add(String text) {
    return add(text.getBytes(StandardCharsets.UTF_8));
  }

  /** The 32 bytes of the hash. Ends it: what is added now is the start of another one. */
  public byte[] bytes() {
    return digest.digest();
  }

  /** The 64 lower-case hexadecimal digits of the hash, which this ends. */
  public String hex() {
    return HexFormat.of().formatHex(bytes());
  }

  /** The first 12 hexadecimal digits, for names of files and folders; this ends the hash. */
  public String abbreviated() {
    return hex().substring(0, ABBREVIATED);
  }
}
