package dev.eventchain.dds;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.messages.MessageCatalog;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** The facts about DDS that are also tested in Python. */
class WireTableTest {

  private static final JsonNode TABLE = table();

  private static JsonNode table() {
    try {
      return new ObjectMapper().readTree(Path.of("../messages/conformance/wire.json").toFile());
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void domainsAreCountedToTheHighestWithPorts() {
    assertEquals(TABLE.get("highest_domain").asInt(), DdsParticipant.HIGHEST_DOMAIN);
  }

  @Test
  void theLoopbackConfigurationIsThatOfTheTable() {
    JsonNode loopback = TABLE.get("loopback");
    assertEquals(
        loopback.get("configuration").asText(),
        DdsParticipant.loopbackConfiguration(loopback.get("tag").asText()));
  }

  @Test
  void identifiersHaveTheSizeOfTheDistribution() {
    JsonNode sizes = TABLE.get("identifier_bytes");
    sizes
        .fieldNames()
        .forEachRemaining(
            name -> assertEquals(sizes.get(name).asInt(), GraphFormat.of(name).size(), name));
  }

  @Test
  void nodesAreToldInTheBytesOfTheDistribution() {
    for (JsonNode row : TABLE.get("graph")) {
      GraphFormat format = GraphFormat.of(row.get("distribution").asText());
      String participant = row.get("participant").asText();
      byte[] said =
          Graph.encode(
              format,
              HexFormat.of().parseHex(participant),
              row.get("node").asText(),
              guids(row.get("readers")),
              guids(row.get("writers")));
      assertEquals(row.get("cdr").asText(), HexFormat.of().formatHex(said));
      Map<String, String> names = new HashMap<>();
      row.get("readers").forEach(guid -> names.put(guid.asText(), "/eventchain_world"));
      row.get("writers").forEach(guid -> names.put(guid.asText(), "/eventchain_world"));
      assertEquals(Map.of(participant, names), Discovery.namesByEndpoint(format, said));
    }
  }

  private static List<byte[]> guids(JsonNode texts) {
    List<byte[]> guids = new ArrayList<>();
    texts.forEach(text -> guids.add(HexFormat.of().parseHex(text.asText())));
    return guids;
  }

  @Test
  void topicsAndTypesHaveTheirNamesOnTheWire() {
    for (JsonNode row : TABLE.get("topics")) {
      String ros = row.get("ros").asText();
      assertEquals(row.get("dds").asText(), DdsNames.topic(ros));
      assertEquals(Optional.of(ros), DdsNames.rosTopic(row.get("dds").asText()));
    }
    MessageCatalog standard = MessageCatalog.of(List.of());
    for (JsonNode row : TABLE.get("types")) {
      String ros = row.get("ros").asText();
      assertEquals(row.get("dds").asText(), DdsNames.type(standard.find(ros).orElseThrow()));
      assertEquals(ros, DdsNames.rosType(row.get("dds").asText()));
    }
  }
}
