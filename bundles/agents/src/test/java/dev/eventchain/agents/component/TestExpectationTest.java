package dev.eventchain.agents.component;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests expected arrays, which may be written as arrays among inputs are. */
class TestExpectationTest {

  private static JsonNode json(String text) throws JsonProcessingException {
    return new ObjectMapper().readTree(text);
  }

  @Test
  void anArrayMayNameOnlyTheElementsThatDiffer() throws Exception {
    TestExpectation expected =
        TestExpectation.exactly(json("{\"count\": 3, \"of\": \"inf\", \"at\": {\"1\": 5}}"));
    assertTrue(expected.accepts(json("[\"inf\", 5.0, \"inf\"]")));
    assertFalse(expected.accepts(json("[\"inf\", 5.1, \"inf\"]")));
    assertFalse(expected.accepts(json("[\"inf\", 5.0]")));
    assertEquals("[\"inf\",5,\"inf\"]", expected.words());
  }

  /**
   * A value that is no array stays as it is written, and is reported for the type of the output.
   */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "{\"count\": 3}",
        "{\"count\": -1, \"of\": 0}",
        "{\"count\": 2, \"of\": 0, \"at\": {\"2\": 1}}",
        "{\"count\": 2, \"of\": 0, \"at\": {\"first\": 1}}"
      })
  void whatIsNoArrayIsNotExpanded(String written) throws Exception {
    assertEquals(json(written), TestValues.expanded(json(written)));
  }
}
