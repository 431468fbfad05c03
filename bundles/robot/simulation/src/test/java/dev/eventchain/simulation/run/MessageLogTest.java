package dev.eventchain.simulation.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.simulation.run.MessageLog.Difference;
import java.nio.ByteBuffer;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Tests which difference of two runs is found. */
class MessageLogTest {

  private static MessageLog log(int... values) {
    MessageLog log = new MessageLog();
    for (int i = 0; i < values.length; i++) {
      log.add(i * 1000L, "/a", ByteBuffer.wrap(new byte[] {(byte) values[i]}));
    }
    return log;
  }

  @Test
  void theSameMessagesAreNoDifference() {
    assertEquals(Optional.empty(), log(1, 2).differenceFrom(log(1, 2)));
    assertEquals(Optional.empty(), log().differenceFrom(log()));
  }

  @Test
  void theFirstDifferenceCounts() {
    Difference found = log(1, 2, 3).differenceFrom(log(1, 4, 5)).orElseThrow();
    assertEquals(1000, found.first().orElseThrow().time());
    assertEquals(2, found.first().orElseThrow().bytes()[0]);
    assertEquals(4, found.second().orElseThrow().bytes()[0]);
  }

  @Test
  void oneMessageMoreIsADifference() {
    Difference found = log(1).differenceFrom(log(1, 2)).orElseThrow();
    assertEquals(Optional.empty(), found.first());
    assertEquals(1000, found.second().orElseThrow().time());
  }

  @Test
  void timeAndTopicCount() {
    MessageLog later = new MessageLog();
    later.add(1, "/a", ByteBuffer.wrap(new byte[] {1}));
    assertTrue(log(1).differenceFrom(later).isPresent());
    MessageLog other = new MessageLog();
    other.add(0, "/b", ByteBuffer.wrap(new byte[] {1}));
    assertTrue(log(1).differenceFrom(other).isPresent());
  }

  @Test
  void longMessagesAreComparedByTheirHashes() {
    byte[] bytes = new byte[100_000];
    MessageLog first = new MessageLog();
    first.add(0, "/a", ByteBuffer.wrap(bytes));
    MessageLog same = new MessageLog();
    same.add(0, "/a", ByteBuffer.wrap(bytes));
    assertEquals(Optional.empty(), first.differenceFrom(same));
    bytes[99_999] = 1;
    MessageLog other = new MessageLog();
    other.add(0, "/a", ByteBuffer.wrap(bytes));
    Difference found = first.differenceFrom(other).orElseThrow();
    assertFalse(found.first().orElseThrow().isWhole());
  }
}
