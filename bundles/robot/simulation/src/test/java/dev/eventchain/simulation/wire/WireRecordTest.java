package dev.eventchain.simulation.wire;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Tests the log of a scenario, merged from those of its processes. */
class WireRecordTest {

  private final WireRecord record = new WireRecord();

  private static JsonNode json(String text) throws JsonProcessingException {
    return new ObjectMapper().readTree(text);
  }

  private void node(String name, String activation, String publications)
      throws JsonProcessingException {
    record.add(
        json(
            """
            {"nodes": [{"name": "%s", "activations": [%s]}], "publications": {%s}}
            """
                .formatted(name, activation, publications)));
  }

  @Test
  void samplesAreNumberedInTheOrderInWhichTheyCouldBeSeen() throws Exception {
    node("Late", "[50, 60, 1, [[\"/scan\", 41]], [[\"/gap\", 62]]]", "\"/gap\": [[62, 60]]");
    node("Early", "[10, 20, 1, [], [[\"/gap\", 21]]]", "\"/gap\": [[21, 20]]");
    record.add(Map.of("/scan", Map.of(41L, 40L)));
    assertEquals(
        json("""
        {"nodes": [
          {"name": "Late", "activations": [[50, 60, 1, [["/scan", 0]], [["/gap", 1]]]]},
          {"name": "Early", "activations": [[10, 20, 1, [], [["/gap", 0]]]]}],
         "publications": {"/gap": [[0, 20], [1, 60]], "/scan": [[0, 40]]}}
        """)
            .toString(),
        record.toJson().toString());
  }

  @Test
  void aSampleThatNobodyWroteIsRefused() throws Exception {
    node("Node", "[50, 60, 1, [[\"/scan\", 41]], []]", "");
    String message = assertThrows(IllegalArgumentException.class, record::toJson).getMessage();
    assertTrue(message.contains("/scan that nobody wrote"), message);
  }

  @Test
  void twoSamplesWithOneNameAreRefused() throws Exception {
    node("One", "", "\"/gap\": [[7, 7]]");
    node("Other", "", "\"/gap\": [[7, 7]]");
    String message = assertThrows(IllegalArgumentException.class, record::toJson).getMessage();
    assertTrue(message.contains("two samples of /gap"), message);
  }
}
