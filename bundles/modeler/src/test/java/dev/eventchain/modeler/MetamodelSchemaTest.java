package dev.eventchain.modeler;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class MetamodelSchemaTest {

  private static final List<String> REFUSED_BY_PROVIDERS =
      List.of("oneOf", "allOf", "not", "minItems", "maxItems", "minimum", "maximum", "pattern");

  @Test
  void theSchemaOfTheLibraryIsAsExpected() throws IOException {
    String actual = MetamodelSchema.nested(Library.eClass("Library")).toPrettyString() + "\n";
    ExpectedFile.check(
        Path.of("src/test/resources/library.schema.json"), actual.replace("\r\n", "\n"));
  }

  @Test
  void schemasKeepToWhatStrictModesAccept() {
    checkStrict(MetamodelSchema.nested(EventchainPackage.Literals.EVENT_CHAIN));
    checkStrict(MetamodelSchema.nested(Library.eClass("Library")));
  }

  @Test
  void everyPointerLeadsToADefinition() {
    ObjectNode schema = MetamodelSchema.nested(EventchainPackage.Literals.EVENT_CHAIN);
    List<JsonNode> pointers = schema.findValues("$ref");
    assertFalse(pointers.isEmpty());
    for (JsonNode pointer : pointers) {
      assertTrue(schema.at(pointer.asText().substring(1)).isObject(), pointer.asText());
    }
  }

  private static void checkStrict(JsonNode schema) {
    if ("object".equals(schema.path("type").asText())) {
      List<String> names = new ArrayList<>();
      schema.get("properties").fieldNames().forEachRemaining(names::add);
      List<String> required = new ArrayList<>();
      schema.get("required").forEach(name -> required.add(name.asText()));
      assertEquals(names, required);
      assertEquals("eClass", names.get(0));
      assertFalse(schema.get("additionalProperties").asBoolean(true));
    }
    REFUSED_BY_PROVIDERS.forEach(keyword -> assertFalse(schema.has(keyword), keyword));
    schema
        .properties()
        .forEach(
            entry -> {
              boolean namesAreFree = Set.of("properties", "$defs").contains(entry.getKey());
              if (namesAreFree) {
                entry.getValue().forEach(MetamodelSchemaTest::checkStrict);
              } else {
                checkStrict(entry.getValue());
              }
            });
    if (schema.isArray()) {
      schema.forEach(MetamodelSchemaTest::checkStrict);
    }
  }
}
