package dev.eventchain.benchmarks;

import dev.eventchain.dds.DdsLibrary;
import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.dds.DdsSample;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.sandbox.PythonEnvironment;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.locks.LockSupport;

/**
 * Measures nodes that {@code python -m eventchain_ros2} runs, from Java: the round-trip time to a
 * node that answers from its callback, compared with a process that echoes the bytes; the loss
 * among 10,000 messages at 1 kHz; and the overhead of a node with a timer beyond the wait for its
 * timer.
 */
public final class CallbackNodeBenchmark {

  private static final int BLOCK = 250;
  private static final int MESSAGES = 10_000;
  private static final long MILLISECOND = 1_000_000;
  private static final int TIMER_SAMPLES = 200;
  private static final MessageCatalog CATALOG = MessageCatalog.of(List.of());
  private static final MessageType FLOAT = CATALOG.find("std_msgs/msg/Float32").orElseThrow();
  private static final MessageType SCAN = CATALOG.find("sensor_msgs/msg/LaserScan").orElseThrow();
  private static final QosSettings QOS = QosSettings.named("default").orElseThrow();

  private final Path repository;
  private final Path scripts;
  private final PythonEnvironment python;
  private final DdsParticipant here;
  private final String tag = "benchmark-" + ProcessHandle.current().pid();

  private CallbackNodeBenchmark(Path repository, Path scripts) {
    this.repository = repository;
    this.scripts = scripts;
    python = PythonEnvironment.ensureWithCycloneDds(System.err::println);
    here = DdsParticipant.loopback(DdsLibrary.load(python.cycloneDds()), 1, tag);
  }

  /**
   * Prints the figures.
   *
   * @param arguments the folder of the repository, then perhaps the number of blocks of 250 round
   *     trips for each of both processes and types
   * @throws IOException if a process cannot be started
   */
  public static void main(String[] arguments) throws IOException {
    Path repository = Path.of(arguments[0]).normalize();
    int blocks = arguments.length > 1 ? Integer.parseInt(arguments[1]) : 12;
    Path scripts = repository.resolve("tests/benchmarks/src/main/resources/wire");
    CallbackNodeBenchmark benchmark = new CallbackNodeBenchmark(repository, scripts);
    benchmark.roundTrips("Float32", FLOAT, CdrCodec.encode(MessageValue.of(FLOAT)), blocks);
    benchmark.roundTrips("LaserScan", SCAN, scan(), blocks);
    benchmark.losses("depth", "reliable", QOS);
    benchmark.losses("all", "reliable", QOS.withHistory(QosSettings.History.KEEP_ALL));
    benchmark.losses(
        "depth", "best_effort", QOS.withReliability(QosSettings.Reliability.BEST_EFFORT));
    benchmark.timer();
    benchmark.here.close();
    System.out.println("load: " + loadAverage());
  }

  private static String loadAverage() throws IOException {
    Path file = Path.of("/proc/loadavg");
    return Files.exists(file) ? Files.readString(file).strip() : "unknown";
  }

  private static byte[] scan() {
    float[] ranges = new float[360];
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = 0.25f * i;
    }
    return CdrCodec.encode(
        MessageValue.of(SCAN)
            .set("header.frame_id", "lidar")
            .set("ranges", ranges)
            .set("intensities", new float[360]));
  }

  private WirePeer callbackNode(
      String prefix,
      MessageType type,
      String name,
      String history,
      String reliability,
      QosSettings qos)
      throws IOException {
    String file = scripts.resolve("callback_node.py").toString();
    List<String> words = List.of("-m", "eventchain_ros2", file, prefix, name, history, reliability);
    Process process = WirePeer.start(repository, python, tag, false, words);
    return WirePeer.of(process, here, "/" + prefix + "_out", "/" + prefix + "_back", type, qos);
  }

  /** Measures blocks of both in turn, so that both have the same conditions. */
  private void roundTrips(String name, MessageType type, byte[] bytes, int blocks)
      throws IOException {
    String file = scripts.resolve("raw_echo.py").toString();
    String prefix = "raw_" + name;
    Process raw = WirePeer.start(repository, python, tag, false, List.of(file, prefix, name));
    RoundTrips byRaw = new RoundTrips();
    RoundTrips byNode = new RoundTrips();
    try (WirePeer echo =
            WirePeer.of(raw, here, "/" + prefix + "_out", "/" + prefix + "_back", type, QOS);
        WirePeer node = callbackNode("node_" + name, type, name, "depth", "reliable", QOS)) {
      echo.greet(bytes);
      node.greet(bytes);
      for (int block = -2; block < blocks; block++) {
        byRaw.measure(echo, bytes, BLOCK);
        byNode.measure(node, bytes, BLOCK);
        if (block == -1) { // the earlier ones were warm-up
          byRaw.clear();
          byNode.clear();
        }
      }
    }
    byRaw.print(name + ", two processes that pass bytes on");
    byNode.print(name + ", a node that answers from its callback");
    byNode.printRatio(byRaw);
  }

  /** Sends numbers at 1 kHz, regardless of the answers. */
  private void losses(String history, String reliability, QosSettings qos) throws IOException {
    String prefix = "loss_" + history + "_" + reliability;
    BitSet returned = new BitSet(MESSAGES);
    int refused;
    try (WirePeer node = callbackNode(prefix, FLOAT, "Float32", history, reliability, qos)) {
      node.greet(CdrCodec.encode(MessageValue.of(FLOAT).set("data", -1)));
      refused = send(node, returned);
      List<DdsSample> rest = node.take(Duration.ofSeconds(2));
      while (!rest.isEmpty()) {
        note(rest, returned);
        rest = node.take(Duration.ofSeconds(2));
      }
    }
    System.out.printf(
        Locale.ROOT,
        "%d numbers at 1 kHz, %s, %s: %d did not come back, %d were refused here%n",
        MESSAGES,
        reliability,
        history.equals("all") ? "all kept" : "depth 10",
        MESSAGES - returned.cardinality(),
        refused);
  }

  /** Returns the number of messages that the writer rejected. */
  private static int send(WirePeer node, BitSet returned) {
    int refused = 0;
    long start = System.nanoTime();
    for (int number = 0; number < MESSAGES; number++) {
      long due = start + number * MILLISECOND;
      while (System.nanoTime() < due) {
        LockSupport.parkNanos(due - System.nanoTime());
      }
      refused += node.write(CdrCodec.encode(MessageValue.of(FLOAT).set("data", number))) ? 0 : 1;
      note(node.take(Duration.ZERO), returned);
    }
    return refused;
  }

  private static void note(List<DdsSample> samples, BitSet returned) {
    for (DdsSample sample : samples) {
      int number = (int) CdrCodec.decode(FLOAT, sample.bytes()).number("data");
      if (number >= 0) {
        returned.set(number);
      }
    }
  }

  private void timer() throws IOException {
    String file = scripts.resolve("timer_node.py").toString();
    String fixtures =
        repository.resolve("bundles/robot/runtime/tests/fixtures").toAbsolutePath().toString();
    List<String> words = List.of("-m", "eventchain_ros2", file, fixtures);
    Process process = WirePeer.start(repository, python, tag, true, words);
    RoundTrips beyond = new RoundTrips();
    InputStream output = process.getInputStream();
    BufferedReader lines =
        new BufferedReader(new InputStreamReader(output, StandardCharsets.UTF_8));
    String line = lines.readLine();
    while (line != null && !line.startsWith("due ")) {
      line = lines.readLine();
    }
    long[] grid = Arrays.stream(line.split(" ", -1)).skip(1).mapToLong(Long::parseLong).toArray();
    Thread drain = new Thread(() -> lines.lines().forEach(ignored -> {}));
    drain.setDaemon(true);
    drain.start();
    try (WirePeer node = WirePeer.of(process, here, "/number", "/doubled", FLOAT, QOS)) {
      node.greet(CdrCodec.encode(MessageValue.of(FLOAT).set("data", -1)));
      Random random = new Random(1);
      for (int number = 1; number <= TIMER_SAMPLES; number++) {
        beyond.add(beyond(node, number, grid, random));
      }
    }
    beyond.print("a node with a timer of 50 ms, beyond the wait for it");
  }

  /**
   * Returns the delay beyond the timer's due time after the sample, which is sent in the middle of
   * a period.
   */
  private static long beyond(WirePeer node, int number, long[] grid, Random random) {
    long period = grid[1];
    long phase = period / 10 + (long) (random.nextDouble() * period * 8 / 10);
    long now = now();
    long tick = grid[0] + ((now - grid[0]) / period + 1) * period;
    LockSupport.parkNanos(tick + phase - now);
    long sent = now();
    node.write(CdrCodec.encode(MessageValue.of(FLOAT).set("data", number)));
    long due = grid[0] + ((sent - grid[0]) / period + 1) * period;
    while (true) {
      for (DdsSample sample : node.take(WirePeer.PATIENCE)) {
        if (CdrCodec.decode(FLOAT, sample.bytes()).number("data") == 2.0 * number) {
          return now() - due;
        }
      }
    }
  }

  private static long now() {
    Instant now = Instant.now();
    return now.getEpochSecond() * 1_000_000_000 + now.getNano();
  }
}
