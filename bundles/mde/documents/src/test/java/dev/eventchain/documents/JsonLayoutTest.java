package dev.eventchain.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the layouts of JSON. */
class JsonLayoutTest {
  private static final JsonMapper MAPPER = new JsonMapper();

  @Test
  void compactTextBreaksLinesBeforeWhatIsMoreThanPlain() throws IOException {
    JsonNode json =
        MAPPER.readTree(
            """
            {"name": "a", "rate": 20.0, "of": ["R-1", "R-2"],
             "input": [{"topic": "/t", "values": [{"n": 1, "u": "m"}, {"n": 2}]}], "none": []}
            """);
    assertEquals(
        """
        {"name": "a", "rate": 20.0, "of": ["R-1", "R-2"],
         "input": [
          {"topic": "/t",
           "values": [
            {"n": 1, "u": "m"},
            {"n": 2}]}],
         "none": []}""",
        JsonLayout.compact(json));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{}",
        "[]",
        "null",
        "\"a \\\"quoted\\\" text\\nof two lines\"",
        "[[1, [2, {\"a\": {}}]], {\"b\\n\": [true, null]}]"
      })
  void compactTextIsTheSameJson(String text) throws IOException {
    JsonNode json = MAPPER.readTree(text);
    assertEquals(json, MAPPER.readTree(JsonLayout.compact(json)));
    assertEquals(json, MAPPER.readTree(JsonLayout.of(json)));
  }
}
