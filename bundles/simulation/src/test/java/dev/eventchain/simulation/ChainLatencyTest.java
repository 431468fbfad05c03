package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.ObjectMapper;
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
    String json = Files.readString(Path.of("src/test/resources/activations", file));
    RunLog log = RunLog.parse(new ObjectMapper().readTree(json));
    List<Long> wanted =
        expected == null
            ? List.of()
            : Arrays.stream(expected.split(" ")).map(Long::valueOf).toList();
    assertEquals(wanted, ChainLatency.of(log, "/scan", "/brake"));
  }
}
