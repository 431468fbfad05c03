package dev.eventchain.documents;

import com.fasterxml.jackson.databind.JsonNode;

/** The formats of documents, in the words of the people who write them. */
public enum DocumentFormat {
  /** Strict JSON (RFC 8259). A value that is {@code null} counts as not written. */
  JSON("property", "an array", "an object"),

  /**
   * YAML, of which only what all its versions read alike is taken for more than text: {@code true},
   * {@code false}, {@code null}, {@code ~}, and decimal numbers without leading zeros. No tags, no
   * aliases.
   */
  YAML("key", "a list", "a mapping");

  private final String key;
  private final String array;
  private final String object;

  DocumentFormat(String key, String array, String object) {
    this.key = key;
    this.array = array;
    this.object = object;
  }

  String key() {
    return key;
  }

  String array() {
    return array;
  }

  String object() {
    return object;
  }

  /** What a value is, in words. */
  String kind(JsonNode node) {
    return switch (node.getNodeType()) {
      case OBJECT -> object;
      case ARRAY -> array;
      case STRING -> "a string";
      case NUMBER -> "a number";
      case BOOLEAN -> "a Boolean";
      case NULL -> this == JSON ? "null" : "nothing";
      default -> "nothing";
    };
  }
}
