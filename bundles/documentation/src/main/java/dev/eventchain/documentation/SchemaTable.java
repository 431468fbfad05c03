package dev.eventchain.documentation;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.StreamSupport;

/** A table of all that a JSON Schema of ours allows, a row for each path. */
final class SchemaTable {

  private record Row(String values, String meaning) {}

  private final JsonNode schema;
  private final Map<String, Row> rows = new LinkedHashMap<>();

  private SchemaTable(JsonNode schema) {
    this.schema = schema;
  }

  /**
   * Returns the table in Markdown.
   *
   * @param root the property to describe; empty for all
   * @param without the property to leave out; empty for none
   */
  static String of(String schema, String root, String without) {
    try {
      SchemaTable table = new SchemaTable(new ObjectMapper().readTree(schema));
      JsonNode start = table.schema;
      table.add(
          root.isEmpty() ? "" : root + ".",
          root.isEmpty() ? start : start.at("/properties/" + root));
      table
          .rows
          .keySet()
          .removeIf(path -> !without.isEmpty() && path.split("[.\\[]", 2)[0].equals(without));
      return table.text();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private String text() {
    StringBuilder text = new StringBuilder("| where | values | |\n|---|---|---|\n");
    rows.forEach(
        (path, row) ->
            text.append("| `")
                .append(path)
                .append("` | ")
                .append(row.values())
                .append(" | ")
                .append(row.meaning().replace("|", "\\|"))
                .append(" |\n"));
    return text.toString();
  }

  private void add(String prefix, JsonNode given) {
    JsonNode node = resolved(given);
    for (Map.Entry<String, JsonNode> each : node.path("properties").properties()) {
      boolean required = isRequired(node, each.getKey());
      addProperty(prefix + each.getKey(), each.getValue(), required);
    }
    JsonNode others = node.path("additionalProperties");
    if (others.isObject()) {
      addProperty(prefix + "NAME", others, false);
    }
    for (String choice : List.of("oneOf", "anyOf")) {
      node.path(choice).forEach(each -> addAlternative(prefix, resolved(each)));
    }
  }

  /**
   * Adds what one of several forms has; nothing of it is required, since another may be written.
   */
  private void addAlternative(String prefix, JsonNode node) {
    ObjectNode form = node.deepCopy();
    form.remove("required");
    add(prefix, form);
    if (form.has("items") && !prefix.isEmpty()) {
      add(prefix.substring(0, prefix.length() - 1) + "[].", form.path("items"));
    }
  }

  private void addProperty(String path, JsonNode given, boolean required) {
    JsonNode node = resolved(given);
    String meaning = given.path("description").asText(node.path("description").asText());
    Row row = new Row(values(node), (required ? "Required. " : "") + meaning);
    if (!row.values().isEmpty() || !row.meaning().isEmpty()) {
      rows.putIfAbsent(path, row);
    }
    add(path + ".", node);
    if (node.has("items")) {
      add(path + "[].", node.path("items"));
    }
  }

  private static boolean isRequired(JsonNode node, String name) {
    return StreamSupport.stream(node.path("required").spliterator(), false)
        .anyMatch(each -> each.asText().equals(name));
  }

  private JsonNode resolved(JsonNode node) {
    String reference = node.path("$ref").asText();
    return reference.isEmpty() ? node : resolved(schema.at(reference.substring(1)));
  }

  /** Returns the values of a property in a few words. */
  private String values(JsonNode node) {
    if (node.has("const")) {
      return "`" + node.path("const").asText() + "`";
    }
    if (node.has("enum")) {
      return StreamSupport.stream(node.path("enum").spliterator(), false)
          .map(each -> "`" + each.asText() + "`")
          .collect(Collectors.joining(", "));
    }
    List<String> kinds = new ArrayList<>();
    for (String choice : List.of("oneOf", "anyOf")) {
      node.path(choice).forEach(each -> kinds.add(values(resolved(each))));
    }
    if (!kinds.isEmpty()) {
      return kinds.stream()
          .filter(each -> !each.isEmpty())
          .distinct()
          .collect(Collectors.joining(" or "));
    }
    JsonNode type = node.path("type");
    if (type.isArray()) {
      return StreamSupport.stream(type.spliterator(), false)
          .map(each -> each.asText().replace("string", "text").replace("array", "list"))
          .collect(Collectors.joining(" or "));
    }
    return type.asText().equals("array")
        ? "list"
        : type.asText().equals("object") ? "" : range(node);
  }

  private static String range(JsonNode node) {
    String type = node.path("type").asText().replace("string", "text");
    boolean from = node.has("minimum");
    boolean to = node.has("maximum");
    return from && to
        ? plain(node.path("minimum")) + " to " + plain(node.path("maximum"))
        : from ? "at least " + plain(node.path("minimum")) : type;
  }

  private static String plain(JsonNode number) {
    return number.decimalValue().toPlainString();
  }
}
