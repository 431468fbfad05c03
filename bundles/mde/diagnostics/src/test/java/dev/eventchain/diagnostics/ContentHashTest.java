package dev.eventchain.diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;

class ContentHashTest {

  @Test
  void isTheHashOfTheContentEachTime() {
    ContentHash memory = new ContentHash(2000);
    Random random = new Random(7);
    for (int turn = 0; turn < 500; turn++) {
      byte[] content = new byte[random.nextInt(90)];
      Arrays.fill(content, (byte) random.nextInt(3));
      assertEquals(new Sha256().add(content).hex(), memory.of(content));
      assertTrue(memory.size() <= 2000);
    }
  }

  @Test
  void aContentThatChangesInPlaceIsAnotherOne() {
    ContentHash memory = new ContentHash(1000);
    byte[] content = "abc".getBytes(StandardCharsets.UTF_8);
    String before = memory.of(content);
    content[0] = 'b';
    assertEquals(Sha256.of("bbc").hex(), memory.of(content));
    content[0] = 'a';
    assertEquals(before, memory.of(content));
  }

  /** Two contents of the same length and checksum, which only a comparison can tell apart. */
  @Test
  void equalChecksumsAreNoEqualContents() {
    byte[] one = "plumless".getBytes(StandardCharsets.UTF_8);
    byte[] other = "buckeroo".getBytes(StandardCharsets.UTF_8);
    assertEquals(checksum(one), checksum(other));
    ContentHash memory = new ContentHash(1000);
    assertEquals(Sha256.of("plumless").hex(), memory.of(one));
    assertEquals(Sha256.of("buckeroo").hex(), memory.of(other));
    assertEquals(Sha256.of("plumless").hex(), memory.of(one));
    assertTrue(memory.size() < 300, "one of them is remembered");
  }

  private static long checksum(byte[] content) {
    CRC32 checksum = new CRC32();
    checksum.update(content);
    return checksum.getValue();
  }
}
