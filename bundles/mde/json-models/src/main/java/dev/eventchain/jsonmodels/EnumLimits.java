package dev.eventchain.jsonmodels;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Keeps the enumerations of a schema within what OpenAI accepts: 1,000 values in all of them, and
 * 15,000 characters in one of more than 250. Enumerations of texts beyond that are removed, the
 * largest first, so that any text is allowed there; the checks of an answer know the values.
 */
public final class EnumLimits {

  static final int VALUES = 1_000;
  static final int LONG_ENUM = 250;
  static final int CHARACTERS = 15_000;

  private static final String ENUM = "enum";

  private EnumLimits() {}

  /** Removes enumerations beyond the limits, and returns the schema. */
  public static ObjectNode keep(ObjectNode schema) {
    List<ObjectNode> free = new ArrayList<>();
    collect(schema, free);
    free.sort(Comparator.comparingInt((ObjectNode each) -> each.get(ENUM).size()).reversed());
    int total = free.stream().mapToInt(each -> each.get(ENUM).size()).sum();
    for (ObjectNode each : free) {
      int size = each.get(ENUM).size();
      if (total > VALUES || (size > LONG_ENUM && characters(each) > CHARACTERS)) {
        each.remove(ENUM);
        total -= size;
      }
    }
    return schema;
  }

  private static int characters(ObjectNode schema) {
    int sum = 0;
    for (JsonNode value : schema.get(ENUM)) {
      sum += value.asText().length();
    }
    return sum;
  }

  /** Collects the enumerations; a property named "enum" contains no array. */
  private static void collect(JsonNode node, List<ObjectNode> found) {
    if (node instanceof ObjectNode object && object.path(ENUM).isArray()) {
      found.add(object);
    }
    node.forEach(child -> collect(child, found));
  }
}
