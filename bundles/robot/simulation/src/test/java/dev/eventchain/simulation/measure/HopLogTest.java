package dev.eventchain.simulation.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.measure.HopLog.Passed;
import dev.eventchain.simulation.verdict.MessageFlow;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests hops in hand-written logs; a member of each file states its purpose. */
class HopLogTest {

  @ParameterizedTest
  @ValueSource(strings = {"slow-reader.json", "two-writers.json", "real-time.json"})
  void hopsAreWhatWasReadOfWhatWasWritten(String file) throws IOException {
    JsonNode json = new ObjectMapper().readTree(Path.of("src/test/resources/hops", file).toFile());
    HopLog log = new HopLog(RunLog.parse(json));
    assertTrue(json.required("hops").size() > 1);
    for (JsonNode hop : json.required("hops")) {
      String topic = hop.path("topic").asText();
      String writer = hop.path("writer").asText();
      Passed passed = log.passed(topic, writer, hop.path("reader").asText());
      assertEquals(numbers(hop.required("waiting")), passed.waiting(), hop.toString());
      assertEquals(numbers(hop.required("age")), passed.ages(), hop.toString());
      assertEquals(!hop.required("samples").isNull(), passed.isKnown(), hop.toString());
      if (passed.isKnown()) {
        assertEquals(numbers(hop.required("samples")), numbers(passed.samples()), hop.toString());
      }
      assertEquals(numbers(hop.required("gaps")), log.gaps(topic, writer), hop.toString());
    }
    json.required("processing")
        .properties()
        .forEach(
            node ->
                assertEquals(
                    numbers(node.getValue()), log.processing(node.getKey()), node.getKey()));
  }

  private static List<Long> numbers(JsonNode array) {
    List<Long> numbers = new ArrayList<>();
    array.forEach(each -> numbers.add(each.asLong()));
    return numbers;
  }

  private static List<Long> numbers(MessageFlow.Samples samples) {
    return List.of(samples.published(), samples.read(), samples.neverRead(), samples.unreadAtEnd());
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 5, 15})
  void samplesAreReadOrNot(int nodes) {
    long notRead = 0;
    for (int seed = 0; seed < 30; seed++) {
      RunLog record = ChainLatencyTest.random(nodes, new Random(seed * 100L + nodes));
      HopLog log = new HopLog(record);
      for (int node = 0; node < nodes; node++) {
        String writer = node == 0 ? MessageFlow.VEHICLE : "N" + (node - 1);
        Passed passed = log.passed("/" + node, writer, "N" + node);
        MessageFlow.Samples samples = passed.samples();
        assertTrue(passed.isKnown());
        assertEquals(record.publicationsOf("/" + node).size(), samples.published());
        assertEquals(
            samples.published(), samples.read() + samples.neverRead() + samples.unreadAtEnd());
        assertTrue(samples.neverRead() >= 0, samples.toString());
        assertEquals(samples.read(), passed.waiting().size());
        assertTrue(passed.ages().containsAll(passed.waiting()));
        assertTrue(Collections.min(passed.waiting()) >= 0);
        notRead += samples.neverRead();
      }
    }
    assertTrue(notRead > 100, notRead + " never read");
  }
}
