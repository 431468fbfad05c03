package dev.eventchain.modeler;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Random;

/** Any JSON that a schema allows. Ids differ, and texts elsewhere are often such ids. */
final class RandomJson {

  private static final JsonNodeFactory JSON = JsonNodeFactory.instance;
  private static final int DEEPEST = 6;
  private static final int IDS = 15;

  private final JsonNode schema;
  private final Random random;
  private int ids;

  RandomJson(JsonNode schema, long seed) {
    this.schema = schema;
    this.random = new Random(seed);
  }

  JsonNode next() {
    ids = 0;
    return value(schema, 0);
  }

  private JsonNode value(JsonNode part, int depth) {
    if (part.has("$ref")) {
      return value(schema.at(part.get("$ref").asText().substring(1)), depth);
    }
    if (part.path("anyOf").isArray()) {
      JsonNode options = part.get("anyOf");
      JsonNode last = options.get(options.size() - 1);
      boolean end = depth > DEEPEST && last.path("type").asText().equals("null");
      return value(end ? last : options.get(random.nextInt(options.size())), depth + 1);
    }
    if (part.path("enum").isArray()) {
      return part.get("enum").get(random.nextInt(part.get("enum").size()));
    }
    return switch (part.get("type").asText()) {
      case "object" -> object(part, depth);
      case "array" -> array(part, depth);
      case "integer" -> JSON.numberNode(random.nextInt(IDS));
      case "number" -> JSON.numberNode(random.nextInt(1000) / 8.0);
      case "boolean" -> JSON.booleanNode(random.nextBoolean());
      case "null" -> JSON.nullNode();
      case "string" -> JSON.textNode(text(part));
      default -> throw new AssertionError(part);
    };
  }

  private String text(JsonNode part) {
    if (part.path("format").asText().equals("date")) {
      return "2026-%02d-%02d".formatted(1 + random.nextInt(12), 1 + random.nextInt(28));
    }
    return random.nextInt(4) > 0 ? "" + random.nextInt(IDS) : "a \"text\" " + random.nextInt();
  }

  private ObjectNode object(JsonNode part, int depth) {
    ObjectNode object = JSON.objectNode();
    String required = part.get("required").toString();
    part.get("properties")
        .properties()
        .forEach(
            property -> {
              String name = property.getKey();
              boolean isId = name.equals("id") && !property.getValue().has("enum");
              if (isId && property.getValue().path("type").asText().equals("integer")) {
                object.put(name, ids++);
              } else if (isId) {
                object.put(name, "" + ids++);
              } else if (required.contains('"' + name + '"') || random.nextBoolean()) {
                object.set(name, value(property.getValue(), depth + 1));
              }
            });
    return object;
  }

  private ArrayNode array(JsonNode part, int depth) {
    ArrayNode array = JSON.arrayNode();
    int size = depth > DEEPEST ? 0 : random.nextInt(3);
    for (int i = 0; i < size; i++) {
      array.add(value(part.get("items"), depth + 1));
    }
    return array;
  }
}
