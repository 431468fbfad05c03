package dev.eventchain.dds;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import us.ihmc.pubsub.publisher.Publisher;

/** Messages to and from Fast DDS, the default middleware of ROS 2. */
class FastDdsTest {

  private static final QosSettings QOS = QosSettings.named("default").orElseThrow();
  private static final MessageType NUMBER = RandomMessages.type("std_msgs/msg/Float32");
  private static final MessageType SCAN = RandomMessages.type("sensor_msgs/msg/LaserScan");
  private static final List<String> SETTINGS =
      List.of(
          "angle_min",
          "angle_max",
          "angle_increment",
          "time_increment",
          "scan_time",
          "range_min",
          "range_max");

  /** Fast DDS has no tags; the domain isolates it from other programs on this machine. */
  private final int domain = 110 + (int) (ProcessHandle.current().pid() % 100);

  private DdsParticipant here;
  private FastDds there;

  @BeforeEach
  void loadLibrary() {
    Wire.library();
  }

  @AfterEach
  void close() {
    there.close();
    here.close();
  }

  /** Opens both sides. The first one has to announce itself again to the second. */
  private void open(boolean fastDdsFirst) throws IOException {
    if (fastDdsFirst) {
      there = new FastDds(domain);
    }
    here =
        DdsParticipant.on(
            Wire.library(), domain, DdsParticipant.loopback("<SPDPInterval>1 s</SPDPInterval>"));
    if (!fastDdsFirst) {
      there = new FastDds(domain);
    }
  }

  private static void await(String what, BooleanSupplier condition) {
    long start = System.nanoTime();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() - start < Wire.PATIENCE.toNanos(), what);
      java.util.concurrent.locks.LockSupport.parkNanos(1_000_000);
    }
  }

  private static MessageValue scan(int index) {
    MessageValue scan =
        MessageValue.of(SCAN)
            .set("header.stamp.sec", index)
            .set("header.stamp.nanosec", 999_999_999L)
            .set("header.frame_id", "lidar")
            .set("ranges", new float[] {1.5f, Float.POSITIVE_INFINITY, index})
            .set("intensities", new float[index]);
    for (int i = 0; i < SETTINGS.size(); i++) {
      scan.set(SETTINGS.get(i), i + 0.25f);
    }
    return scan;
  }

  private static FastDds.Scan plain(MessageValue scan) {
    FastDds.Scan plain = new FastDds.Scan();
    plain.sec = (Integer) scan.get("header.stamp.sec");
    plain.nanosec = (int) scan.number("header.stamp.nanosec");
    plain.frameId = (String) scan.get("header.frame_id");
    for (int i = 0; i < SETTINGS.size(); i++) {
      plain.settings[i] = (Float) scan.get(SETTINGS.get(i));
    }
    plain.ranges = (float[]) scan.get("ranges");
    plain.intensities = (float[]) scan.get("intensities");
    return plain;
  }

  private static void assertSame(MessageValue expected, FastDds.Scan actual) {
    FastDds.Scan plain = plain(expected);
    assertEquals(plain.sec, actual.sec);
    assertEquals(plain.nanosec, actual.nanosec);
    assertEquals(plain.frameId, actual.frameId);
    assertArrayEquals(plain.settings, actual.settings);
    assertArrayEquals(plain.ranges, actual.ranges);
    assertArrayEquals(plain.intensities, actual.intensities);
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void fastDdsGetsWhatIsWritten(boolean fastDdsFirst) throws IOException, InterruptedException {
    open(fastDdsFirst);
    BlockingQueue<Heard> scans = new LinkedBlockingQueue<>();
    BlockingQueue<Heard> numbers = new LinkedBlockingQueue<>();
    there.subscribe(
        "rt/scan", new FastDds.ScanType(), (scan, stamp) -> scans.add(new Heard(scan, stamp)));
    there.subscribe(
        "rt/brake",
        new FastDds.NumberType(),
        (number, stamp) -> numbers.add(new Heard(number, stamp)));
    DdsWriter scanWriter = here.writer("/scan", SCAN, QOS);
    DdsWriter numberWriter = here.writer("/brake", NUMBER, QOS);
    assertTrue(scanWriter.waitForMatches(1, Wire.PATIENCE));
    assertTrue(numberWriter.waitForMatches(1, Wire.PATIENCE));
    // Until Fast DDS has discovered the writers, too, their samples are lost.
    MessageValue zero = MessageValue.of(NUMBER);
    await("the first scan", () -> write(scanWriter, scan(0), 0) && isHeard(scans));
    await("the first number", () -> write(numberWriter, zero, 0) && isHeard(numbers));
    for (int i = 1; i < 6; i++) {
      assertTrue(write(scanWriter, scan(i), 123_456_789L * i));
      assertTrue(write(numberWriter, MessageValue.of(NUMBER).set("data", i + 0.5f), i));
      Heard scan = next(scans);
      assertSame(scan(i), (FastDds.Scan) scan.message);
      assertEquals(123_456_789L * i, scan.stamp);
      Heard number = next(numbers);
      assertEquals(i + 0.5f, ((FastDds.Value) number.message).data);
      assertEquals(i, number.stamp);
    }
  }

  /**
   * A sample received by Fast DDS; the first messages, possibly written several times, contain 0.
   */
  private record Heard(Object message, long stamp) {}

  private static Heard next(BlockingQueue<Heard> heard) throws InterruptedException {
    Heard next = heard.poll(Wire.PATIENCE.toSeconds(), TimeUnit.SECONDS);
    while (next != null && next.stamp == 0) {
      next = heard.poll(Wire.PATIENCE.toSeconds(), TimeUnit.SECONDS);
    }
    return next;
  }

  private static boolean isHeard(BlockingQueue<?> heard) {
    try {
      return heard.poll(100, TimeUnit.MILLISECONDS) != null;
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  private static boolean write(DdsWriter writer, MessageValue message, long stamp) {
    return writer.write(CdrCodec.encode(message), stamp);
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void whatFastDdsWritesArrives(boolean fastDdsFirst) throws IOException, InterruptedException {
    open(fastDdsFirst);
    Publisher scans = there.publisher("rt/scan", new FastDds.ScanType());
    Publisher numbers = there.publisher("rt/brake", new FastDds.NumberType());
    BlockingQueue<MessageValue> scansHeard = new LinkedBlockingQueue<>();
    BlockingQueue<MessageValue> numbersHeard = new LinkedBlockingQueue<>();
    DdsReader scanReader = here.reader("/scan", SCAN, QOS, s -> scansHeard.add(decode(SCAN, s)));
    DdsReader numberReader =
        here.reader("/brake", NUMBER, QOS, s -> numbersHeard.add(decode(NUMBER, s)));
    assertTrue(scanReader.waitForMatches(1, Wire.PATIENCE));
    assertTrue(numberReader.waitForMatches(1, Wire.PATIENCE));
    // Until Fast DDS has discovered the readers, too, its samples are lost.
    await("the first scan", () -> isHeard(scans, plain(scan(0)), scansHeard));
    await("the first number", () -> isHeard(numbers, number(0), numbersHeard));
    for (int i = 1; i < 6; i++) {
      scans.write(plain(scan(i)));
      numbers.write(number(i));
      assertEquals(scan(i), next(scansHeard, scan(0)));
      MessageValue expected = MessageValue.of(NUMBER).set("data", (float) i);
      assertEquals(expected, next(numbersHeard, MessageValue.of(NUMBER)));
    }
  }

  private static FastDds.Value number(int value) {
    FastDds.Value number = new FastDds.Value();
    number.data = value;
    return number;
  }

  private static MessageValue decode(MessageType type, DdsSample sample) {
    CdrCodec.requireMessage(type, sample.bytes());
    return CdrCodec.decode(type, sample.bytes());
  }

  private static boolean isHeard(
      Publisher publisher, Object message, BlockingQueue<MessageValue> heard) {
    try {
      publisher.write(message);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return isHeard(heard);
  }

  /** Returns the next sample other than the first one, which was possibly written several times. */
  private static MessageValue next(BlockingQueue<MessageValue> heard, MessageValue first)
      throws InterruptedException {
    MessageValue message = first;
    while (message != null && message.equals(first)) {
      message = heard.poll(Wire.PATIENCE.toSeconds(), TimeUnit.SECONDS);
    }
    return message;
  }
}
