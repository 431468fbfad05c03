package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/** Documented limits of providers for schemas in their strict modes. */
final class ProviderLimits {
  private static final Set<String> EVERYWHERE =
      Set.of(
          "type",
          "properties",
          "required",
          "additionalProperties",
          "items",
          "enum",
          "anyOf",
          "$ref",
          "$defs",
          "description");

  private final JsonNode root;
  private final List<String> problems = new ArrayList<>();
  private int properties;
  private int optional;
  private int alternatives;
  private int enumValues;
  private int characters;
  private int depth;
  private boolean recursive;

  private ProviderLimits(JsonNode root) {
    this.root = root;
    walk(root);
    root.path("$defs").properties().forEach(each -> characters += each.getKey().length());
    root.path("$defs").forEach(this::walk);
    follow(root, 0, new HashSet<>());
    check(root.path("type").asText().equals("object"), "the root is no object");
  }

  /** All required, at most 5,000 properties, 10 levels, 1,000 enum values, 120,000 characters. */
  static List<String> openAi(JsonNode schema) {
    ProviderLimits limits = new ProviderLimits(schema);
    limits.check(limits.optional == 0, "not required: " + limits.optional);
    limits.check(limits.properties <= 5_000, "properties: " + limits.properties);
    limits.check(limits.depth <= 10, "levels: " + limits.depth);
    limits.check(limits.enumValues <= 1_000, "enum values: " + limits.enumValues);
    limits.check(limits.characters <= 120_000, "characters: " + limits.characters);
    return limits.problems;
  }

  /** No recursion, at most 24 properties that are not required and 16 with alternatives. */
  static List<String> anthropic(JsonNode schema) {
    ProviderLimits limits = new ProviderLimits(schema);
    limits.check(!limits.recursive, "recursive");
    limits.check(limits.optional <= 24, "not required: " + limits.optional);
    limits.check(limits.alternatives <= 16, "with alternatives: " + limits.alternatives);
    return limits.problems;
  }

  /** Gemini accepts some recursion; the tasks use none. */
  static List<String> gemini(JsonNode schema) {
    ProviderLimits limits = new ProviderLimits(schema);
    limits.check(!limits.recursive, "recursive");
    return limits.problems;
  }

  private void check(boolean holds, String problem) {
    if (!holds) {
      problems.add(problem);
    }
  }

  private void walk(JsonNode schema) {
    Set<String> keywords = new TreeSet<>();
    schema.fieldNames().forEachRemaining(keywords::add);
    keywords.removeAll(EVERYWHERE);
    check(keywords.isEmpty(), "keywords: " + keywords);
    check(!schema.path("type").isArray(), "several types");
    if (schema.path("type").asText().equals("object")) {
      check(schema.path("additionalProperties").isBoolean(), "open to other properties");
      check(!schema.path("additionalProperties").asBoolean(true), "open to other properties");
      properties += schema.path("properties").size();
      optional += schema.path("properties").size() - schema.path("required").size();
      schema.path("properties").properties().forEach(each -> characters += each.getKey().length());
    }
    alternatives += schema.has("anyOf") ? 1 : 0;
    countEnum(schema.path("enum"));
    schema.path("properties").forEach(this::walk);
    schema.path("anyOf").forEach(this::walk);
    if (schema.has("items")) {
      walk(schema.get("items"));
    }
  }

  private void countEnum(JsonNode values) {
    int length = 0;
    for (JsonNode value : values) {
      length += value.asText().length();
    }
    enumValues += values.size();
    characters += length;
    check(values.size() <= 250 || length <= 15_000, "one enum: " + length);
  }

  private void follow(JsonNode schema, int level, Set<String> entered) {
    depth = Math.max(depth, level);
    if (schema.has("$ref")) {
      String pointer = schema.get("$ref").asText().substring(1);
      check(root.at(pointer).isObject(), "leads nowhere: " + pointer);
      Set<String> inner = new HashSet<>(entered);
      if (inner.add(pointer)) {
        follow(root.at(pointer), level, inner);
      } else {
        recursive = true;
      }
    }
    int below = level + (schema.path("type").asText().matches("object|array") ? 1 : 0);
    schema.path("properties").forEach(each -> follow(each, below, entered));
    schema.path("anyOf").forEach(each -> follow(each, level, entered));
    if (schema.has("items")) {
      follow(schema.get("items"), below, entered);
    }
  }
}
