package dev.eventchain.documents;

import com.fasterxml.jackson.databind.JsonNode;

/** Formats of documents, with the terms that their users know. */
public enum DocumentFormat {
  /** Strict JSON (RFC 8259). A {@code null} value counts as absent. */
  JSON("property", "an array", "an object"),

  /**
   * YAML without tags and aliases. Only scalars that all versions of YAML read alike are more than
   * text: {@code true}, {@code false}, {@code null}, {@code ~}, and decimal numbers without leading
   * zeros.
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

  /** Returns the kind of a value in words. */
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
