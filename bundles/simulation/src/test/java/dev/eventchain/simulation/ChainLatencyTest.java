package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.metamodel.eventchain.LatencyKind;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Latencies in records of activations made by hand; the files say in a member what they show. */
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

  /** The "latency constraints between any two nodes, whatever their order in the model". */
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
    assertEquals(numbers(expected), ChainLatency.between(log(file), first, last, dataAge));
  }

  private static RunLog log(String file) throws IOException {
    String json = Files.readString(Path.of("src/test/resources/activations", file));
    return RunLog.parse(new ObjectMapper().readTree(json));
  }

  private static List<Long> numbers(String text) {
    return text == null ? List.of() : Arrays.stream(text.split(" ")).map(Long::valueOf).toList();
  }
}
