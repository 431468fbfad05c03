package dev.eventchain.lsp.project;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.lsp.text.ProtocolJson;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** A JSON Schema, asked what may stand at a place. Of alternatives, all are possible. */
final class ProjectSchema {

  private static final List<String> ALTERNATIVES = List.of("allOf", "anyOf", "oneOf");
  private static final List<String> CONDITIONAL = List.of("then", "else");

  private final JsonNode root;

  ProjectSchema(String text) {
    try {
      this.root = ProtocolJson.read(text);
    } catch (JsonProcessingException e) {
      throw new IllegalArgumentException(e);
    }
  }

  /** Returns what describes the value at a path; nothing for a path that must not be. */
  List<JsonNode> at(List<String> path) {
    List<JsonNode> found = withAlternatives(List.of(root));
    for (String step : path) {
      List<JsonNode> next = new ArrayList<>();
      found.forEach(each -> below(each, step).ifPresent(next::add));
      found = withAlternatives(next);
    }
    return found;
  }

  private Optional<JsonNode> below(JsonNode schema, String step) {
    if (step.equals(YamlPlace.ITEM)) {
      return object(schema.path("items"));
    }
    JsonNode named = schema.path("properties").path(step);
    return object(named.isMissingNode() ? schema.path("additionalProperties") : named);
  }

  private static Optional<JsonNode> object(JsonNode node) {
    return Optional.of(node).filter(JsonNode::isObject);
  }

  private List<JsonNode> withAlternatives(List<JsonNode> schemas) {
    List<JsonNode> all = new ArrayList<>();
    Set<JsonNode> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    schemas.forEach(each -> add(each, all, seen));
    return all;
  }

  private void add(JsonNode schema, List<JsonNode> all, Set<JsonNode> seen) {
    if (!seen.add(schema)) {
      return;
    }
    all.add(schema);
    if (schema.has("$ref")) {
      add(referred(schema.get("$ref").asText()), all, seen);
    }
    for (String name : ALTERNATIVES) {
      schema.path(name).forEach(each -> object(each).ifPresent(it -> add(it, all, seen)));
    }
    CONDITIONAL.forEach(name -> object(schema.path(name)).ifPresent(it -> add(it, all, seen)));
  }

  /** Returns the part of the schema that a reference in it names: {@code #/$defs/factor}. */
  private JsonNode referred(String reference) {
    return root.at(reference.substring(1));
  }

  /**
   * A key of a mapping.
   *
   * @param isRequired true if the mapping needs it, at least in one alternative
   * @param values what describes its value
   */
  record Key(String name, boolean isRequired, List<JsonNode> values) {

    /** Returns whether its value may be a mapping, or a list. */
    boolean isOf(String type) {
      return values.stream().anyMatch(each -> isOf(each, type));
    }

    private static boolean isOf(JsonNode schema, String type) {
      return schema.path("type").asText().equals(type);
    }

    /** Returns whether its value may stand behind it on the line. */
    boolean isScalar() {
      return values.stream()
          .anyMatch(
              each ->
                  each.has("enum")
                      || each.has("const")
                      || (each.has("type") && !isOf(each, "object") && !isOf(each, "array")));
    }
  }

  /** Returns the keys that the mapping at a path may have, those that it needs first. */
  List<Key> keys(List<String> path) {
    Map<String, Key> found = new LinkedHashMap<>();
    for (JsonNode schema : at(path)) {
      Set<String> required = new HashSet<>();
      schema.path("required").forEach(each -> required.add(each.asText()));
      for (Map.Entry<String, JsonNode> each : schema.path("properties").properties()) {
        boolean isRequired = required.contains(each.getKey());
        object(each.getValue())
            .map(it -> new Key(each.getKey(), isRequired, withAlternatives(List.of(it))))
            .ifPresent(key -> found.merge(key.name(), key, ProjectSchema::both));
      }
    }
    return found.values().stream().sorted(Comparator.comparing(key -> !key.isRequired())).toList();
  }

  private static Key both(Key first, Key second) {
    List<JsonNode> values = new ArrayList<>(first.values());
    values.addAll(second.values());
    return new Key(first.name(), first.isRequired() || second.isRequired(), values);
  }

  /** Returns the values that may stand at a path, as far as the schema lists them. */
  static List<String> values(List<JsonNode> schemas) {
    List<String> values = new ArrayList<>();
    for (JsonNode schema : schemas) {
      if (schema.has("const")) {
        values.add(schema.get("const").asText());
      }
      schema.path("enum").forEach(each -> values.add(each.asText()));
      if (Key.isOf(schema, "boolean")) {
        values.addAll(List.of("true", "false"));
      }
    }
    return values.stream().distinct().toList();
  }

  /** Returns the description of what may stand at a place; empty if there is none. */
  static String description(List<JsonNode> schemas) {
    return schemas.stream()
        .filter(each -> each.has("description"))
        .map(each -> each.get("description").asText())
        .findFirst()
        .orElse("");
  }
}
