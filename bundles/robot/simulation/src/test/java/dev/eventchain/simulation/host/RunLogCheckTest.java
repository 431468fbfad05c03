package dev.eventchain.simulation.host;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.simulation.host.NodeSession.Outbound;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;

/** Tests that each line of {@code records/bad.csv} invalidates the good log at one place. */
class RunLogCheckTest {

  private static final ObjectMapper JSON = new ObjectMapper();

  private static JsonNode good() throws IOException {
    return JSON.readTree(Path.of("src/test/resources/records/good.json").toFile());
  }

  private static void check(JsonNode test) {
    List<Outbound> commands = new ArrayList<>();
    for (JsonNode command : test.get("commands")) {
      commands.add(
          new Outbound(
              command.get(0).asLong(), command.get(1).asInt(), ByteBuffer.wrap(new byte[0])));
    }
    new RunLogCheck(
            RunLog.parse(test.get("finished")), test.get("configuration"), test.get("end").asLong())
        .check(commands);
  }

  @Test
  void whatTheProtocolGivesIsBelieved() throws IOException {
    JsonNode record = good();
    assertDoesNotThrow(() -> check(record));
  }

  @ParameterizedTest
  @CsvFileSource(
      resources = "/records/bad.csv",
      delimiter = ';',
      quoteCharacter = '`',
      numLinesToSkip = 1)
  void whatCannotBeIsNot(String place, String value, String problem) throws IOException {
    JsonNode record = good();
    JsonPointer pointer = JsonPointer.compile(place);
    String last = pointer.last().getMatchingProperty();
    if (record.at(pointer.head()) instanceof ArrayNode array) {
      array.set(pointer.last().getMatchingIndex(), JSON.readTree(value));
    } else {
      ((ObjectNode) record.at(pointer.head())).set(last, JSON.readTree(value));
    }
    Exception exception = assertThrows(IllegalArgumentException.class, () -> check(record));
    assertEquals(problem, exception.getMessage());
  }
}
