package dev.eventchain.dds;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Status events of writers and readers. */
class EventsTest {

  private static final QosSettings QOS = QosSettings.named("default").orElseThrow();
  private static final MessageType FLOAT = RandomMessages.type("std_msgs/msg/Float32");
  private static final byte[] NUMBER = CdrCodec.encode(MessageValue.of(FLOAT));

  private DdsParticipant here;
  private DdsParticipant there;

  @BeforeEach
  void open() {
    String tag = Wire.newTag();
    here = Wire.onTheWire(tag);
    there = Wire.onTheWire(tag);
  }

  @AfterEach
  void close() {
    here.close();
    there.close();
  }

  /** Waits for an event of this kind, ignoring others. */
  private static Optional<DdsEvent> first(DdsEvent.Kind kind, Supplier<List<DdsEvent>> events) {
    long start = System.nanoTime();
    while (System.nanoTime() - start < Wire.PATIENCE.toNanos()) {
      for (DdsEvent event : events.get()) {
        if (event.kind() == kind) {
          return Optional.of(event);
        }
      }
      Thread.onSpinWait();
    }
    return Optional.empty();
  }

  /** Returns the policy; the same peer may be discovered and counted twice. */
  private static String incompatible(Supplier<List<DdsEvent>> events) {
    return first(DdsEvent.Kind.INCOMPATIBLE_QOS, events).map(DdsEvent::policy).orElse("");
  }

  private void assertIncompatible(String policy, QosSettings offered, QosSettings requested) {
    assertEquals(
        policy, QosSettings.incompatibilities(offered, requested).get(0).policy(), "as the rules");
    DdsWriter writer = here.writer("/" + policy, FLOAT, offered);
    DdsReader reader = there.reader("/" + policy, FLOAT, requested);
    assertEquals(policy, incompatible(writer::events));
    assertEquals(policy, incompatible(reader::events));
    assertEquals(0, writer.matched());
    assertEquals(0, reader.matched());
  }

  @Test
  void incompatibleQualityOfServiceNamesThePolicyAtBothEnds() {
    assertIncompatible(
        "reliability", QOS.withReliability(QosSettings.Reliability.BEST_EFFORT), QOS);
    assertIncompatible(
        "durability", QOS, QOS.withDurability(QosSettings.Durability.TRANSIENT_LOCAL));
    assertIncompatible("deadline", QOS, QOS.withDeadline(Duration.ofSeconds(1)));
    assertIncompatible(
        "liveliness", QOS, QOS.withLiveliness(QosSettings.Liveliness.MANUAL_BY_TOPIC));
  }

  @Test
  void whatMatchesHasNoEvents() {
    DdsWriter writer = here.writer("/quiet", FLOAT, QOS);
    DdsReader reader =
        there.reader("/quiet", FLOAT, QOS.withReliability(QosSettings.Reliability.BEST_EFFORT));
    Wire.connect(writer, reader);
    assertTrue(writer.write(NUMBER));
    assertEquals(1, reader.take(Wire.PATIENCE).size());
    assertEquals(List.of(), writer.events());
    List<DdsEvent> others = new ArrayList<>(reader.events());
    others.remove(new DdsEvent(DdsEvent.Kind.LIVELINESS_GAINED, 1, "")); // of the new writer
    assertEquals(List.of(), others);
  }

  @Test
  void aMissedDeadlineIsToldAtBothEnds() {
    QosSettings every = QOS.withDeadline(Duration.ofMillis(200));
    DdsWriter writer = here.writer("/deadline", FLOAT, every);
    DdsReader reader = there.reader("/deadline", FLOAT, every);
    Wire.connect(writer, reader);
    assertTrue(writer.write(NUMBER));
    assertEquals(1, reader.take(Wire.PATIENCE).size());
    assertTrue(first(DdsEvent.Kind.DEADLINE_MISSED, reader::events).isPresent());
    assertTrue(first(DdsEvent.Kind.DEADLINE_MISSED, writer::events).isPresent());
  }

  @Test
  void aWriterThatIsSilentForLongerThanItsLeaseIsToldAndSoIsItsReturn() {
    QosSettings lease =
        QOS.withLiveliness(QosSettings.Liveliness.MANUAL_BY_TOPIC)
            .withLease(Duration.ofMillis(300));
    DdsReader reader = there.reader("/alive", FLOAT, lease);
    DdsWriter writer = here.writer("/alive", FLOAT, lease);
    Wire.connect(writer, reader);
    writer.assertLiveliness();
    assertTrue(first(DdsEvent.Kind.LIVELINESS_LOST, reader::events).isPresent());
    assertTrue(first(DdsEvent.Kind.LIVELINESS_LOST, writer::events).isPresent());
    assertTrue(writer.write(NUMBER));
    assertTrue(first(DdsEvent.Kind.LIVELINESS_GAINED, reader::events).isPresent());
  }

  @Test
  void aReaderThatDoesNotAcknowledgeHoldsUpAWriterThatKeepsAllForAShortTimeOnly() {
    // No samples are taken, and the reader keeps as many as it can. Cyclone stores what arrives, so
    // the writer continues, and each write ends soon in any case.
    QosSettings all = QOS.withHistory(QosSettings.History.KEEP_ALL);
    DdsWriter writer = here.writer("/full", FLOAT, all);
    DdsReader reader = there.reader("/full", FLOAT, all);
    Wire.connect(writer, reader);
    int taken = 0;
    for (int i = 0; i < 2000; i++) {
      taken += writer.write(NUMBER, i) ? 1 : 0;
    }
    long start = System.nanoTime();
    int came = 0;
    while (came < taken && System.nanoTime() - start < Wire.PATIENCE.toNanos()) {
      came += reader.take(Wire.PATIENCE).size();
    }
    assertEquals(taken, came);
  }
}
