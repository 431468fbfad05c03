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
record Parameter(
    String name, ArgumentType type, String description, boolean required, List<String> words) {

  private static final int LONGEST = 10_000;
  private static final int MOST = 1000;

  /** Types of arguments. */
  enum ArgumentType {
    TEXT,
    WHOLE,
    NUMBER,
    FLAG,
    TEXTS,
    OBJECTS
  }

  static Parameter of(String name, ArgumentType type, String description) {
    return new Parameter(name, type, description, false, List.of());
  }

  static Parameter required(String name, ArgumentType type, String description) {
    return new Parameter(name, type, description, true, List.of());
  }

  static Parameter oneOf(String name, String description, List<String> words) {
    return new Parameter(name, ArgumentType.TEXT, description, false, words);
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
    boolean typed =
        switch (type) {
          case TEXT -> isText(value);
          case WHOLE -> isWhole(value);
          case NUMBER -> value instanceof Number;
          case FLAG -> value instanceof Boolean;
          case TEXTS -> isListOf(value, Parameter::isText);
          case OBJECTS -> isListOf(value, Map.class::isInstance);
        };
    return typed && (words.isEmpty() || words.contains(value));
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
    Map<String, Object> schema =
        new LinkedHashMap<>(
            switch (type) {
              case TEXT -> Map.of("type", "string");
              case WHOLE -> Map.of("type", "integer", "minimum", 0);
              case NUMBER -> Map.of("type", "number");
              case FLAG -> Map.of("type", "boolean");
              case TEXTS -> Map.of("type", "array", "items", Map.of("type", "string"));
              case OBJECTS -> Map.of("type", "array", "items", Map.of("type", "object"));
            });
    schema.put("description", description);
    if (!words.isEmpty()) {
      schema.put("enum", words);
    }
    return schema;
  }
}
