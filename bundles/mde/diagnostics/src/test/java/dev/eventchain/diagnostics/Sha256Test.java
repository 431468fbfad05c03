package dev.eventchain.diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class Sha256Test {

  /** FIPS 180-2, appendix B.1. */
  private static final String ABC =
      "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

  @Test
  void isTheHashOfTheStandard() {
    assertEquals(ABC, Sha256.of("abc").hex());
    assertEquals("ba7816bf8f01", Sha256.of("abc").abbreviated());
    assertEquals(32, Sha256.of("").bytes().length);
  }

  @Test
  void textsAndBytesAddUp() {
    byte[] first = "a".getBytes(StandardCharsets.UTF_8);
    assertEquals(ABC, new Sha256().add(first).add("bc").hex());
  }
}
