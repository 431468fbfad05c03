package dev.eventchain.lsp.project;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
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

  private final JsonObject root;

  ProjectSchema(String text) {
    this.root = JsonParser.parseString(text).getAsJsonObject();
  }

  /** Returns what describes the value at a path; nothing for a path that must not be. */
  List<JsonObject> at(List<String> path) {
    List<JsonObject> found = withAlternatives(List.of(root));
    for (String step : path) {
      List<JsonObject> next = new ArrayList<>();
      found.forEach(each -> below(each, step).ifPresent(next::add));
      found = withAlternatives(next);
    }
    return found;
  }

  private Optional<JsonObject> below(JsonObject schema, String step) {
    if (step.equals(YamlPlace.ITEM)) {
      return object(schema.get("items"));
    }
    JsonElement named = properties(schema).get(step);
    return object(named == null ? schema.get("additionalProperties") : named);
  }

  private static Optional<JsonObject> object(JsonElement element) {
    return element instanceof JsonObject object ? Optional.of(object) : Optional.empty();
  }

  private static JsonObject properties(JsonObject schema) {
    return object(schema.get("properties")).orElseGet(JsonObject::new);
  }

  private List<JsonObject> withAlternatives(List<JsonObject> schemas) {
    List<JsonObject> all = new ArrayList<>();
    Set<JsonObject> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    schemas.forEach(each -> add(each, all, seen));
    return all;
  }

  private void add(JsonObject schema, List<JsonObject> all, Set<JsonObject> seen) {
    if (!seen.add(schema)) {
      return;
    }
    all.add(schema);
    if (schema.has("$ref")) {
      add(referred(schema.get("$ref").getAsString()), all, seen);
    }
    for (String name : ALTERNATIVES) {
      if (schema.get(name) instanceof JsonArray array) {
        array.forEach(each -> object(each).ifPresent(it -> add(it, all, seen)));
      }
    }
    CONDITIONAL.forEach(name -> object(schema.get(name)).ifPresent(it -> add(it, all, seen)));
  }

  /** Returns the part of the schema that a reference in it names: {@code #/$defs/factor}. */
  private JsonObject referred(String reference) {
    JsonObject found = root;
    for (String step : reference.substring(1).split("/", -1)) {
      found = step.isEmpty() ? found : found.getAsJsonObject(step);
    }
    return found;
  }

  /**
   * A key of a mapping.
   *
   * @param isRequired true if the mapping needs it, at least in one alternative
   * @param values what describes its value
   */
  record Key(String name, boolean isRequired, List<JsonObject> values) {

    /** Returns whether its value may be a mapping, or a list. */
    boolean isOf(String type) {
      return values.stream().anyMatch(each -> isOf(each, type));
    }

    private static boolean isOf(JsonObject schema, String type) {
      return schema.get("type") instanceof JsonPrimitive one && one.getAsString().equals(type);
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
    for (JsonObject schema : at(path)) {
      JsonElement required = schema.get("required");
      for (Map.Entry<String, JsonElement> each : properties(schema).entrySet()) {
        boolean isRequired =
            required instanceof JsonArray names && names.contains(new JsonPrimitive(each.getKey()));
        object(each.getValue())
            .map(it -> new Key(each.getKey(), isRequired, withAlternatives(List.of(it))))
            .ifPresent(key -> found.merge(key.name(), key, ProjectSchema::both));
      }
    }
    return found.values().stream().sorted(Comparator.comparing(key -> !key.isRequired())).toList();
  }

  private static Key both(Key first, Key second) {
    List<JsonObject> values = new ArrayList<>(first.values());
    values.addAll(second.values());
    return new Key(first.name(), first.isRequired() || second.isRequired(), values);
  }

  /** Returns the values that may stand at a path, as far as the schema lists them. */
  static List<String> values(List<JsonObject> schemas) {
    List<String> values = new ArrayList<>();
    for (JsonObject schema : schemas) {
      if (schema.get("const") instanceof JsonPrimitive only) {
        values.add(only.getAsString());
      }
      if (schema.get("enum") instanceof JsonArray all) {
        all.forEach(each -> values.add(each.getAsString()));
      }
      if (Key.isOf(schema, "boolean")) {
        values.addAll(List.of("true", "false"));
      }
    }
    return values.stream().distinct().toList();
  }

  /** Returns the description of what may stand at a place; empty if there is none. */
  static String description(List<JsonObject> schemas) {
    return schemas.stream()
        .filter(each -> each.has("description"))
        .map(each -> each.get("description").getAsString())
        .findFirst()
        .orElse("");
  }
}
