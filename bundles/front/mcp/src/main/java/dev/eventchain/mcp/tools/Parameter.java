package dev.eventchain.mcp.tools;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/**
 * An argument of a tool.
 *
 * @param words the values that it may have; empty if it may have any of its type
 */
record Parameter(String name, Type type, String description, boolean required, List<String> words) {

  private static final int LONGEST = 10_000;
  private static final int MOST = 1000;

  /** Types of arguments. */
  enum Type {
    TEXT(Map.of("type", "string"), Parameter::isText),
    WHOLE(Map.of("type", "integer", "minimum", 0), Parameter::isWhole),
    NUMBER(Map.of("type", "number"), Number.class::isInstance),
    FLAG(Map.of("type", "boolean"), Boolean.class::isInstance),
    TEXTS(
        Map.of("type", "array", "items", Map.of("type", "string")),
        value -> isListOf(value, Parameter::isText)),
    OBJECTS(
        Map.of("type", "array", "items", Map.of("type", "object")),
        value -> isListOf(value, Map.class::isInstance));

    private final Map<String, Object> schema;
    private final Predicate<Object> check;

    Type(Map<String, Object> schema, Predicate<Object> check) {
      this.schema = schema;
      this.check = check;
    }
  }

  static Parameter of(String name, Type type, String description) {
    return new Parameter(name, type, description, false, List.of());
  }

  static Parameter required(String name, Type type, String description) {
    return new Parameter(name, type, description, true, List.of());
  }

  static Parameter oneOf(String name, String description, List<String> words) {
    return new Parameter(name, Type.TEXT, description, false, words);
  }

  private static boolean isText(Object value) {
    return value instanceof String text && text.length() <= LONGEST;
  }

  private static boolean isWhole(Object value) {
    return value instanceof Integer number && number >= 0;
  }

  private static boolean isListOf(Object value, Predicate<Object> each) {
    return value instanceof List<?> list && list.size() <= MOST && list.stream().allMatch(each);
  }

  /** Returns whether a value may be given. */
  boolean accepts(Object value) {
    return type.check.test(value) && (words.isEmpty() || words.contains(value));
  }

  /** Returns what may be given, in words. */
  String expected() {
    if (!words.isEmpty()) {
      return "one of " + String.join(", ", words);
    }
    return switch (type) {
      case TEXT -> "a text of at most " + LONGEST + " characters";
      case WHOLE -> "a whole number from 0";
      case NUMBER -> "a number";
      case FLAG -> "true or false";
      case TEXTS -> "a list of texts";
      case OBJECTS -> "a list of objects";
    };
  }

  /** Returns the JSON schema. */
  Map<String, Object> schema() {
    Map<String, Object> schema = new LinkedHashMap<>(type.schema);
    schema.put("description", description);
    if (!words.isEmpty()) {
      schema.put("enum", words);
    }
    return schema;
  }
}
