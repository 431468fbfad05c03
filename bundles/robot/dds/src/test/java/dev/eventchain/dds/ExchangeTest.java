package dev.eventchain.dds;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Messages between two participants, over the loopback interface. */
class ExchangeTest {

  private static final QosSettings RELIABLE = QosSettings.named("default").orElseThrow();
  private static final MessageType FLOAT = RandomMessages.type("std_msgs/msg/Float32");

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

  private static byte[] number(float value) {
    return CdrCodec.encode(MessageValue.of(FLOAT).set("data", value));
  }

  private static float number(DdsSample sample) {
    return (Float) CdrCodec.decode(FLOAT, sample.bytes()).get("data");
  }

  /** Takes samples until there are this many, or until a timeout. */
  private static List<DdsSample> take(DdsReader reader, int count) {
    List<DdsSample> samples = new ArrayList<>();
    long start = System.nanoTime();
    while (samples.size() < count && System.nanoTime() - start < Wire.PATIENCE.toNanos()) {
      samples.addAll(reader.take(Wire.PATIENCE));
    }
    return samples;
  }

  @Test
  void messagesOfAllStandardTypesArriveUnchanged() {
    RandomMessages random = new RandomMessages(20261123);
    Map<String, byte[]> written = new TreeMap<>();
    Map<String, DdsWriter> writers = new TreeMap<>();
    Map<String, DdsReader> readers = new TreeMap<>();
    for (String name : RandomMessages.CATALOG.names()) {
      MessageType type = RandomMessages.type(name);
      String topic = "/all/" + name.replace("/msg/", "_");
      writers.put(name, here.writer(topic, type, RELIABLE));
      readers.put(name, there.reader(topic, type, RELIABLE));
      written.put(name, CdrCodec.encode(random.next(type)));
    }
    assertTrue(written.size() >= 150, "only " + written.keySet());
    for (String name : written.keySet()) {
      DdsWriter writer = writers.get(name);
      Wire.connect(writer, readers.get(name));
      assertTrue(writer.write(written.get(name)), name);
      List<DdsSample> samples = take(readers.get(name), 1);
      assertEquals(1, samples.size(), name);
      MessageType type = RandomMessages.type(name);
      // The network may pad to a multiple of four bytes.
      assertEquals(
          CdrCodec.decode(type, written.get(name)),
          CdrCodec.decode(type, samples.get(0).bytes()),
          name);
      CdrCodec.requireMessage(type, samples.get(0).bytes());
    }
  }

  @Test
  void samplesArriveOnceAndInOrderWithTheTimesTheyWereGiven() {
    QosSettings all = RELIABLE.withHistory(QosSettings.History.KEEP_ALL);
    DdsWriter writer = here.writer("/numbers", FLOAT, all);
    DdsReader reader = there.reader("/numbers", FLOAT, all);
    Wire.connect(writer, reader);
    long[] stamps = new java.util.Random(3).longs(3000, 0, 4_000_000_000_000_000_000L).toArray();
    for (int i = 0; i < 3000; i++) {
      while (!writer.write(number(i), stamps[i])) {
        Thread.onSpinWait(); // the reader's host is busy
      }
    }
    List<DdsSample> samples = take(reader, 3000);
    assertEquals(3000, samples.size());
    for (int i = 0; i < 3000; i++) {
      assertEquals(i, number(samples.get(i)));
      assertEquals(stamps[i], samples.get(i).sourceTimestamp());
    }
    assertEquals(List.of(), reader.take());
  }

  @Test
  void theWriterChoosesTheSourceTimestampAndOtherwiseItIsNow() {
    DdsWriter writer = here.writer("/stamped", FLOAT, RELIABLE);
    DdsReader reader = there.reader("/stamped", FLOAT, RELIABLE);
    Wire.connect(writer, reader);
    long before = TimeUnit.MILLISECONDS.toNanos(System.currentTimeMillis());
    assertTrue(writer.write(number(1), 123_456_789_012L));
    assertTrue(writer.write(number(2), 0));
    assertTrue(writer.write(number(3)));
    List<DdsSample> samples = take(reader, 3);
    long after = TimeUnit.MILLISECONDS.toNanos(System.currentTimeMillis() + 1);
    assertEquals(123_456_789_012L, samples.get(0).sourceTimestamp());
    assertEquals(0, samples.get(1).sourceTimestamp());
    assertTrue(samples.get(2).sourceTimestamp() >= before, "in the past");
    assertTrue(samples.get(2).sourceTimestamp() <= after, "in the future");
  }

  @Test
  void largeMessagesArriveWhole() {
    MessageType type = RandomMessages.type("sensor_msgs/msg/PointCloud2");
    byte[] data = new byte[3_000_000];
    new java.util.Random(1).nextBytes(data);
    DdsWriter writer = here.writer("/points", type, RELIABLE);
    DdsReader reader = there.reader("/points", type, RELIABLE);
    Wire.connect(writer, reader);
    assertTrue(writer.write(CdrCodec.encode(MessageValue.of(type).set("data", data))));
    MessageValue cloud = CdrCodec.decode(type, take(reader, 1).get(0).bytes());
    assertArrayEquals(data, (byte[]) cloud.get("data"));
  }

  @Test
  void aListenerGetsEachSampleAlsoAfterOneThatItFailedOn() throws InterruptedException {
    BlockingQueue<Float> heard = new LinkedBlockingQueue<>();
    BlockingQueue<Throwable> failures = new LinkedBlockingQueue<>();
    DdsWriter writer = here.writer("/heard", FLOAT, RELIABLE);
    DdsReader listening =
        there.reader(
            "/heard",
            FLOAT,
            RELIABLE,
            sample -> {
              Thread.currentThread().setUncaughtExceptionHandler((t, e) -> failures.add(e));
              heard.add(number(sample));
              if (number(sample) == 1) {
                throw new IllegalStateException("one is refused");
              }
            });
    Wire.connect(writer, listening);
    for (int i = 0; i < 3; i++) {
      assertTrue(writer.write(number(i)));
      assertEquals(i, heard.poll(2, TimeUnit.MINUTES));
    }
    assertEquals("one is refused", failures.take().getMessage());
  }

  @Test
  void aLateReaderGetsWhatATransientLocalWriterKeeps() {
    QosSettings kept = RELIABLE.withDurability(QosSettings.Durability.TRANSIENT_LOCAL).withDepth(2);
    DdsWriter writer = here.writer("/map", FLOAT, kept);
    for (int i = 0; i < 5; i++) {
      assertTrue(writer.write(number(i)));
    }
    DdsReader reader = there.reader("/map", FLOAT, kept);
    List<Float> numbers = take(reader, 2).stream().map(ExchangeTest::number).toList();
    assertEquals(List.of(3f, 4f), numbers);
  }

  @Test
  void samplesOfSeveralWritersAreToldApart() {
    DdsReader reader = there.reader("/shared", FLOAT, RELIABLE);
    DdsWriter first = here.writer("/shared", FLOAT, RELIABLE);
    DdsWriter second = here.writer("/shared", FLOAT, RELIABLE);
    assertTrue(reader.waitForMatches(2, Wire.PATIENCE));
    assertTrue(first.waitForMatches(1, Wire.PATIENCE));
    assertTrue(second.waitForMatches(1, Wire.PATIENCE));
    assertTrue(first.write(number(1)));
    DdsSample one = take(reader, 1).get(0);
    assertTrue(second.write(number(2)));
    DdsSample two = take(reader, 1).get(0);
    assertTrue(first.write(number(3)));
    DdsSample three = take(reader, 1).get(0);
    assertEquals(one.publication(), three.publication());
    assertNotEquals(one.publication(), two.publication());
  }

  @Test
  void writersAndReadersKnowHowManyTheyMatch() {
    DdsWriter writer = here.writer("/matched", FLOAT, RELIABLE);
    assertEquals(0, writer.matched());
    DdsReader reader = there.reader("/matched", FLOAT, RELIABLE);
    assertTrue(writer.waitForMatches(1, Wire.PATIENCE));
    assertEquals(1, writer.matched());
    DdsReader local = here.reader("/matched", FLOAT, RELIABLE);
    assertTrue(writer.waitForMatches(2, Wire.PATIENCE));
    assertEquals(1, local.matched());
    reader.close();
    long start = System.nanoTime();
    while (writer.matched() > 1 && System.nanoTime() - start < Wire.PATIENCE.toNanos()) {
      Thread.onSpinWait();
    }
    assertEquals(1, writer.matched());
    assertEquals(false, writer.waitForMatches(2, java.time.Duration.ofMillis(50)));
  }
}
