package dev.eventchain.llm.chat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;

/**
 * The JSON Schema of an answer in the shapes that models take. The model that is asked determines
 * which one is sent; answers in all shapes have the same meaning.
 *
 * @param nested with definitions and pointers to them; every property is required, and may be null
 *     where there is nothing to say
 * @param flat without recursion and with few alternatives; what there is nothing to say of is left
 *     out
 * @param told where nothing enforces it, as in a chat window: as nested, but people are spared what
 *     strict modes ask for. What would be null or empty need not be written
 */
public record AnswerSchema(JsonNode nested, JsonNode flat, JsonNode told) {

  /** What a model takes. */
  public enum Shape {
    /** As it is: strict modes that want every property. */
    NESTED {
      @Override
      JsonNode of(AnswerSchema schema) {
        return schema.nested;
      }
    },
    /** As it is: strict modes that know no recursion. */
    FLAT {
      @Override
      JsonNode of(AnswerSchema schema) {
        return schema.flat;
      }
    },
    /** Nobody is made to write what says nothing. */
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

  /** One that is told as it is nested. */
  public AnswerSchema(JsonNode nested, JsonNode flat) {
    this(nested, flat, nested);
  }

  /** One that is the same in every shape. */
  public static AnswerSchema of(JsonNode schema) {
    return new AnswerSchema(schema, schema, schema);
  }

  /** With nothing but a shape. */
  AnswerSchema in(Shape shape) {
    return of(shape.of(this));
  }

  /**
   * What is sent.
   *
   * @throws IllegalStateException if no shape has been chosen: a request would be recorded as one
   *     that it is not
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

  /** Null or an empty array. */
  private static boolean saysNothing(JsonNode property) {
    for (JsonNode alternative : property.path("anyOf")) {
      if (alternative.path("type").asText().equals("null")) {
        return true;
      }
    }
    return property.path("type").asText().equals("array");
  }
}
