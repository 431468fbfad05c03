package dev.eventchain.simulation.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.model.eventchain.LatencyKind;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.host.RunLog.Activation;
import dev.eventchain.simulation.host.RunLog.SampleId;
import dev.eventchain.simulation.verdict.MessageFlow;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests latencies in hand-written logs of activations; a member of each file states its purpose.
 */
class ChainLatencyTest {

  @ParameterizedTest
  @CsvSource({
    "straight.json, 30 35",
    "repeated-command.json, 30",
    "skipped-sample.json, 30 40",
    "two-paths.json, 45",
    "same-instant.json, 0",
    "feedback.json, 20 20",
    "no-connection.json,"
  })
  void latencyFollowsTheActivationGraph(String file, String expected) throws IOException {
    RunLog log = log(file);
    List<Long> wanted = numbers(expected);
    assertEquals(wanted, ChainLatency.reactions(log, "/scan", "/brake"));
  }

  /**
   * Quotes the issue: "latency constraints between any two nodes, whatever their order in the
   * model".
   */
  @ParameterizedTest
  @CsvSource({
    "straight.json, A, B, REACTION, 30 35",
    "straight.json, A, A, REACTION, 15 15",
    "straight.json, B, B, REACTION, 15 20",
    "reversed-order.json, A, B, REACTION, 30 35",
    "repeated-command.json, A, B, DATA_AGE, 30 80",
    "repeated-command.json, A, B, REACTION, 30",
    "feedback.json, A, B, REACTION, 20 20",
    "feedback.json, B, A, REACTION, 100",
    "two-paths.json, A, C, REACTION, 45",
    "two-paths.json, B, C, REACTION, 25",
    "no-connection.json, A, B, REACTION,",
    "timer.json, A, B, REACTION, 20 20",
    "straight.json, A, Missing, REACTION,",
    "straight.json, Missing, B, REACTION,"
  })
  void timeBetweenAnyTwoNodes(
      String file, String first, String last, LatencyKind kind, String expected)
      throws IOException {
    boolean dataAge = kind == LatencyKind.DATA_AGE;
    assertEquals(
        numbers(expected),
        ChainLatency.between(log(file), first, last, dataAge).stream()
            .map(ChainLatency.Latency::time)
            .toList());
  }

  /** For each node of the first time: its name, waiting and execution. */
  @ParameterizedTest
  @CsvSource({
    "two-paths.json, A, C, A 5+0 C 35+5",
    "feedback.json, B, A, B 0+5 A 90+5",
    "repeated-command.json, A, A, A 10+5"
  })
  void timeConsistsOfWaitingAndExecution(String file, String first, String last, String parts)
      throws IOException {
    ChainLatency.Latency found = ChainLatency.between(log(file), first, last, false).get(0);
    assertEquals(
        parts,
        found.parts().stream()
            .map(part -> part.node() + " " + part.waiting() + "+" + part.execution())
            .collect(Collectors.joining(" ")));
  }

  @Test
  void whatCountsBeforeAStimulusIsPartOfItsWaiting() throws IOException {
    RunLog log = log("two-paths.json");
    ChainLatency.Latency arrived = ChainLatency.between(log, "A", "C", false).get(0);
    ChainLatency.Latency measured =
        ChainLatency.between(log, "A", "C", false, topic -> topic.equals("/scan") ? 7 : 0).get(0);
    assertEquals(arrived.time() + 7, measured.time());
    assertEquals(arrived.parts().get(0).waiting() + 7, measured.parts().get(0).waiting());
    assertEquals(arrived.parts().get(1), measured.parts().get(1));
    assertEquals(
        arrived,
        ChainLatency.between(log, "A", "C", false, topic -> topic.isEmpty() ? 7 : 0).get(0));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 5, 8, 15})
  void partsSumUpToTheTime(int nodes) {
    int found = 0;
    for (int seed = 0; seed < 30; seed++) {
      RunLog log = random(nodes, new Random(seed * 100L + nodes));
      HopLog hops = new HopLog(log);
      Map<String, List<Long>> ages = new HashMap<>();
      for (boolean dataAge : new boolean[] {false, true}) {
        for (ChainLatency.Latency each :
            ChainLatency.between(log, "N0", "N" + (nodes - 1), dataAge)) {
          found++;
          long sum = each.parts().stream().mapToLong(p -> p.waiting() + p.execution()).sum();
          assertEquals(each.time(), sum, each.toString());
          assertTrue(
              each.parts().stream().allMatch(p -> p.waiting() >= 0 && p.execution() >= 0),
              each.toString());
          assertConsistsOfHops(hops, ages, each);
          assertEquals("N0", each.parts().get(0).node());
          assertEquals("N" + (nodes - 1), each.parts().get(each.parts().size() - 1).node());
        }
      }
    }
    assertTrue(found > 100, found + " times");
  }

  /**
   * Asserts that each part is one age of a hop from the node before, and the processing time of the
   * node.
   */
  private static void assertConsistsOfHops(
      HopLog hops, Map<String, List<Long>> known, ChainLatency.Latency latency) {
    String writer = MessageFlow.VEHICLE;
    for (ChainLatency.Part part : latency.parts()) {
      String from = writer;
      List<Long> ages =
          known.computeIfAbsent(
              part.topic() + " " + writer + " " + part.node(),
              hop -> hops.passed(part.topic(), from, part.node()).ages());
      assertTrue(ages.contains(part.waiting()), part + " is none of " + ages);
      assertTrue(hops.processing(part.node()).contains(part.execution()), part.toString());
      writer = part.node();
    }
  }

  /** In real time a sample can arrive before its writer's activation has ended. */
  @Test
  void noPartIsNegativeInRealTime() throws IOException {
    String json = Files.readString(Path.of("src/test/resources/hops/real-time.json"));
    RunLog log = RunLog.parse(new ObjectMapper().readTree(json));
    List<ChainLatency.Latency> found = ChainLatency.between(log, "A", "B", false);
    assertEquals(List.of(8L, 19L), found.stream().map(ChainLatency.Latency::time).toList());
    assertEquals(
        List.of(
            new ChainLatency.Part("/scan", "A", 1, 5), new ChainLatency.Part("/gap", "B", 1, 1)),
        found.get(0).parts());
    assertEquals(
        List.of(
            new ChainLatency.Part("/scan", "A", 11, 5), new ChainLatency.Part("/gap", "B", 2, 1)),
        found.get(1).parts());
  }

  /**
   * Returns a log of nodes in a row with individual periods, offsets and execution times. Each
   * reads the last sample of the topic before its own, and some read topics of other nodes before
   * or behind them.
   */
  static RunLog random(int nodes, Random random) {
    Map<String, List<Activation>> activations = new LinkedHashMap<>();
    Map<String, Map<Long, Long>> publications = new LinkedHashMap<>();
    List<Long> duration = new ArrayList<>();
    for (int topic = 0; topic <= nodes; topic++) {
      duration.add(topic == 0 ? 0 : (long) random.nextInt(10));
      long period = 10L + random.nextInt(40);
      long offset = random.nextInt(10);
      Map<Long, Long> times = new LinkedHashMap<>();
      for (long i = 0; i < 40; i++) {
        times.put(i, offset + i * period + duration.get(topic));
      }
      publications.put("/" + topic, times);
    }
    for (int node = 0; node < nodes; node++) {
      List<String> inputs = new ArrayList<>(List.of("/" + node));
      inputs.add("/" + (1 + random.nextInt(nodes)));
      String output = "/" + (node + 1);
      List<Activation> done = new ArrayList<>();
      for (Map.Entry<Long, Long> written : publications.get(output).entrySet()) {
        long start = written.getValue() - duration.get(node + 1);
        List<SampleId> reads = new ArrayList<>();
        for (String input : inputs) {
          publications.get(input).entrySet().stream()
              .filter(sample -> sample.getValue() <= start)
              .reduce((earlier, later) -> later)
              .ifPresent(sample -> reads.add(new SampleId(input, sample.getKey())));
        }
        List<SampleId> writes = List.of(new SampleId(output, written.getKey()));
        done.add(new Activation(start, written.getValue(), 0, reads, writes));
      }
      activations.put("N" + node, done);
    }
    return new RunLog(activations, publications);
  }

  private static RunLog log(String file) throws IOException {
    String json = Files.readString(Path.of("src/test/resources/activations", file));
    return RunLog.parse(new ObjectMapper().readTree(json));
  }

  private static List<Long> numbers(String text) {
    return text == null ? List.of() : Arrays.stream(text.split(" ")).map(Long::valueOf).toList();
  }
}
