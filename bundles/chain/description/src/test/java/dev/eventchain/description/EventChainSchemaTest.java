package dev.eventchain.description;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.RandomJson;
import dev.eventchain.jsonmodels.ModelComparison;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventChain;
import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class EventChainSchemaTest {

  private static final List<String> IDS = List.of("R-1", "R-2");

  /** Findings that the schema rules out. */
  private static final Set<String> STRUCTURAL =
      Set.of(
          "modeler.consumer.unknown",
          "modeler.feature.unknown",
          "modeler.reference.unresolved",
          "modeler.type.illegal",
          "modeler.value.type");

  private final EventChainSchema schema =
      EventChainSchema.of(IDS, List.of("std_msgs/msg/Float32", "sensor_msgs/msg/LaserScan"));

  @Test
  void whateverASchemaAllowsIsRead() {
    for (ObjectNode shape : List.of(schema.nested(), schema.flat())) {
      JsonSchema validator =
          JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012).getSchema(shape);
      for (int seed = 0; seed < 300; seed++) {
        JsonNode chain = new RandomJson(shape, seed).next();
        assertEquals(Set.of(), validator.validate(chain), chain::toPrettyString);
        List<Diagnostic> findings =
            read(chain).diagnostics().stream()
                .filter(finding -> STRUCTURAL.contains(finding.id()))
                .toList();
        assertEquals(List.of(), findings, chain::toPrettyString);
      }
    }
  }

  @Test
  void aDescriptionIsTheSameInAnObjectAndAsAnArray() throws IOException {
    for (int seed = 0; seed < 100; seed++) {
      JsonNode chain = new RandomJson(schema.nested(), seed).next();
      Modeled<EventChain> wrapped = read(chain);
      Modeled<EventChain> array = read(EventChainSchema.components(chain));
      assertEquals(
          List.of(),
          ModelComparison.compare(array.root(), wrapped.root(), each -> SourceLocation.NONE));
      assertEquals(ids(array), ids(wrapped));
    }
    JsonNode empty = new JsonMapper().readTree("{\"components\": []}");
    assertEquals(List.of("modeler.chain.empty"), ids(read(empty)));
    JsonNode more = new JsonMapper().readTree("{\"components\": [], \"x\": 1}");
    assertEquals(List.of("modeler.chain.empty", "modeler.feature.unknown"), ids(read(more)));
    JsonNode other = new JsonMapper().readTree("{\"parts\": []}");
    assertEquals(List.of("modeler.value.type"), ids(read(other)));
  }

  private static List<String> ids(Modeled<?> modeled) {
    return modeled.diagnostics().stream().map(Diagnostic::id).sorted().toList();
  }

  @Test
  void anEnumerationThatIsTooMuchIsLeftOut() {
    List<String> types = IntStream.range(0, 1_200).mapToObj(i -> "a_msgs/msg/T" + i).toList();
    ObjectNode much = EventChainSchema.of(IDS, types).flat();
    assertFalse(much.at("/$defs/message_type").has("enum"));
    assertEquals(2, much.at("/$defs/requirement/enum").size());
    List<String> wide = IntStream.range(0, 300).mapToObj(i -> "a".repeat(60) + i).toList();
    assertFalse(EventChainSchema.of(IDS, wide).nested().at("/$defs/message_type").has("enum"));
    assertFalse(EventChainSchema.of(List.of(), wide).nested().at("/$defs/requirement").has("enum"));
  }

  private static Modeled<EventChain> read(JsonNode chain) {
    SourceLocation nowhere = SourceLocation.NONE;
    List<WrittenRequirement> requirements =
        IDS.stream().map(id -> new WrittenRequirement(id, "text", nowhere)).toList();
    return EventChainReader.read(
        SourceText.of("chain.json", chain.toPrettyString()),
        "chain",
        requirements,
        OptionalDouble.empty());
  }
}
