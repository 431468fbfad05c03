package dev.eventchain.llm.chat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;

/**
 * The JSON Schema of an answer in the shapes that models accept. The model determines the shape
 * that is sent; answers in all shapes have the same meaning.
 *
 * @param nested with definitions and references; every property is required, but may be null
 * @param flat without recursion and with few alternatives; empty properties are omitted
 * @param told as nested, for use without enforcement, as in a chat window; null or empty properties
 *     may be omitted
 */
public record AnswerSchema(JsonNode nested, JsonNode flat, JsonNode told) {

  /** Shapes of schemas. */
  public enum Shape {
    /** The nested schema: strict modes that require every property. */
    NESTED {
      @Override
      JsonNode of(AnswerSchema schema) {
        return schema.nested;
      }
    },
    /** The flat schema: strict modes without recursion. */
    FLAT {
      @Override
      JsonNode of(AnswerSchema schema) {
        return schema.flat;
      }
    },
    /** The relaxed schema: null or empty properties may be omitted. */
    TOLD {
      @Override
      JsonNode of(AnswerSchema schema) {
        JsonNode told = schema.told.deepCopy();
        relax(told);
        return told;
      }
    };

    abstract JsonNode of(AnswerSchema schema);
  }

  /** Creates a schema whose relaxed shape derives from the nested one. */
  public AnswerSchema(JsonNode nested, JsonNode flat) {
    this(nested, flat, nested);
  }

  /** Returns a schema that is the same in every shape. */
  public static AnswerSchema of(JsonNode schema) {
    return new AnswerSchema(schema, schema, schema);
  }

  /** Returns a schema reduced to one shape. */
  AnswerSchema in(Shape shape) {
    return of(shape.of(this));
  }

  /**
   * Returns the schema to send.
   *
   * @throws IllegalStateException if no shape has been chosen: the request would be recorded
   *     incorrectly
   */
  public JsonNode chosen() {
    if (!nested.equals(flat)) {
      throw new IllegalStateException("the shape of the schema has not been chosen");
    }
    return nested;
  }

  private static void relax(JsonNode schema) {
    if (schema.path("properties").isObject() && schema.path("required").isArray()) {
      ArrayNode required = ((ObjectNode) schema).arrayNode();
      for (JsonNode name : schema.get("required")) {
        if (!saysNothing(schema.get("properties").path(name.asText()))) {
          required.add(name);
        }
      }
      ((ObjectNode) schema).set("required", required);
    }
    schema.forEach(AnswerSchema::relax);
  }

  /** Returns whether a property is null or an empty array. */
  private static boolean saysNothing(JsonNode property) {
    for (JsonNode alternative : property.path("anyOf")) {
      if (alternative.path("type").asText().equals("null")) {
        return true;
      }
    }
    return property.path("type").asText().equals("array");
  }
}
