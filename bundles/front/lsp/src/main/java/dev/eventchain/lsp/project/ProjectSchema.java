package dev.eventchain.lsp.project;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.lsp.text.ProtocolJson;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** A JSON Schema, asked what may stand at a place. Of alternatives, all are possible. */
final class ProjectSchema {

  private static final List<String> ALTERNATIVES = List.of("allOf", "anyOf", "oneOf");

  /** The most alternatives of what a mapping needs that are told apart. */
  private static final int MOST_NEEDS = 30;

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
    return withAlternatives(named(path));
  }

  /** Returns the same, with alternatives and references still in it. */
  private List<JsonNode> named(List<String> path) {
    List<JsonNode> found = List.of(root);
    for (String step : path) {
      Set<JsonNode> next = Collections.newSetFromMap(new IdentityHashMap<>());
      List<JsonNode> ordered = new ArrayList<>();
      for (JsonNode each : withAlternatives(found)) {
        below(each, step).filter(next::add).ifPresent(ordered::add);
      }
      found = ordered;
    }
    return found;
  }

  /**
   * Returns the sets of keys that the mapping at a path needs, one for each alternative that goes
   * with the keys that it has.
   */
  List<Set<String>> needs(List<String> path, Set<String> present) {
    List<Set<String>> all = List.of(Set.of());
    for (JsonNode each : named(path)) {
      all = both(all, needs(each, present));
    }
    return all;
  }

  private List<Set<String>> needs(JsonNode schema, Set<String> present) {
    Set<String> required = required(schema);
    List<Set<String>> all = List.of(required);
    if (schema.has("$ref")) {
      all = both(all, needs(referred(schema.get("$ref").asText()), present));
    }
    if (schema.has("if")) {
      boolean holds = present.containsAll(required(schema.get("if")));
      all = both(all, needs(schema.path(holds ? "then" : "else"), present));
    }
    for (JsonNode each : schema.path("allOf")) {
      all = both(all, needs(each, present));
    }
    for (String name : List.of("anyOf", "oneOf")) {
      List<Set<String>> alternatives = new ArrayList<>();
      schema.path(name).forEach(each -> alternatives.addAll(needs(each, present)));
      List<Set<String>> begun =
          alternatives.stream().filter(it -> !Collections.disjoint(it, present)).toList();
      all = both(all, begun.isEmpty() ? alternatives : begun);
    }
    return all;
  }

  private static Set<String> required(JsonNode schema) {
    Set<String> required = new LinkedHashSet<>();
    schema.path("required").forEach(each -> required.add(each.asText()));
    return required;
  }

  /** Returns each set of one list with each of another one, which is left out if it is empty. */
  private static List<Set<String>> both(List<Set<String>> some, List<Set<String>> others) {
    List<Set<String>> all = new ArrayList<>();
    for (Set<String> each : some) {
      for (Set<String> other : others.isEmpty() ? List.of(Set.<String>of()) : others) {
        Set<String> joined = new LinkedHashSet<>(each);
        joined.addAll(other);
        all.add(joined);
      }
    }
    return all.stream().distinct().limit(MOST_NEEDS).toList();
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
      Set<String> required = required(schema);
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
