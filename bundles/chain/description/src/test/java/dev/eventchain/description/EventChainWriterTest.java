package dev.eventchain.description;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.xmi.XmiStore;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class EventChainWriterTest {

  private static final Path EXAMPLE = Path.of("../../../examples/aeb");

  @Test
  void whatIsWrittenIsReadBackAsTheSameModel() {
    SourceText text = SourceText.read(EXAMPLE.resolve("software-base/components.json"));
    EventChain chain = read(text);
    String written = EventChainWriter.write(chain);
    assertEquals(xmi(chain), xmi(read(SourceText.of("written.json", written))));
    assertEquals(written, EventChainWriter.write(chain));
  }

  @Test
  void policiesSurvive() {
    String json =
        """
        [{"name": "A", "input": [], "output": [{"topic": "/a", "message_type": "std_msgs/msg/Float32",
          "qos_profile": {"profile": "sensor_data", "reliability": "RELIABLE", "depth": 3, "deadline": 50.0,
            "liveliness": "MANUAL_BY_TOPIC", "lease_duration": 75.0},
          "values": [{"name": "a", "field": "data"}]}]}]
        """;
    EventChain chain = read(SourceText.of("a.json", json));
    String written = EventChainWriter.write(chain);
    assertTrue(written.contains("\"reliability\": \"RELIABLE\""), written);
    assertTrue(written.contains("\"lease_duration\": 75.0"), written);
    assertEquals(xmi(chain), xmi(read(SourceText.of("b.json", written))));
  }

  @Test
  void whatLeavesTheChainIsSaid() {
    String json =
        """
        [{"name": "A", "requirements": ["R-1"], "input": [], "output": [
          {"topic": "/a", "message_type": "std_msgs/msg/Bool", "consumer": "external",
           "requirements": ["R-1"], "values": [{"name": "a", "field": "data"}]},
          {"topic": "/b", "message_type": "std_msgs/msg/Bool",
           "values": [{"name": "b", "field": "data"}]}]}]
        """;
    EventChain chain = read(SourceText.of("a.json", json));
    assertEquals(List.of(true, false), chain.getData().stream().map(Data::isExternal).toList());
    assertEquals(chain.getRequirements(), chain.getData().get(0).getSatisfies());
    String written = EventChainWriter.write(chain);
    assertEquals(xmi(chain), xmi(read(SourceText.of("b.json", written))));
  }

  private static EventChain read(SourceText text) {
    Modeled<EventChain> modeled =
        EventChainReader.read(
            text,
            "aeb",
            List.of(new WrittenRequirement("R-1", "The system shall signal.", SourceLocation.NONE)),
            OptionalDouble.empty());
    assertEquals(List.of(), modeled.diagnostics());
    return modeled.root();
  }

  private static String xmi(EventChain chain) {
    return new String(XmiStore.toBytes(chain), StandardCharsets.UTF_8);
  }
}
