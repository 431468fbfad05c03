package dev.eventchain.workspace.launch;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.XmlElement;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * An element of a launch file, alike for XML, YAML and Python.
 *
 * @param kind its name in XML, with underscores; {@code unknown} if it is not known what it does
 * @param attributes empty where a value is there, but not known
 * @param file relative to the workspace
 */
public record LaunchElement(
    String kind,
    Map<String, Optional<String>> attributes,
    List<LaunchElement> children,
    String file,
    int line) {

  /** The key in YAML of the elements in one that has attributes, too. */
  private static final String CHILDREN = "children";

  /** Returns the children of the root of a file in XML. */
  public static List<LaunchElement> of(String file, XmlElement root) {
    return root.children().stream().map(child -> element(file, child)).toList();
  }

  private static LaunchElement element(String file, XmlElement xml) {
    Map<String, Optional<String>> attributes = new LinkedHashMap<>();
    xml.attributes().forEach((name, value) -> attributes.put(name, Optional.of(value)));
    return new LaunchElement(
        xml.name().replace('-', '_'), attributes, of(file, xml), file, xml.location().line());
  }

  /** Returns the elements of a file in YAML, below {@code launch}. */
  public static List<LaunchElement> of(String file, Document yaml) {
    return list(file, yaml, "/launch");
  }

  private static List<LaunchElement> list(String file, Document yaml, String pointer) {
    List<LaunchElement> found = new ArrayList<>();
    JsonNode list = yaml.root().at(pointer);
    for (int i = 0; list.isArray() && i < list.size(); i++) {
      String entry = Document.below(pointer, i);
      list.get(i).fieldNames().forEachRemaining(kind -> found.add(entry(file, yaml, entry, kind)));
    }
    return found;
  }

  private static LaunchElement entry(String file, Document yaml, String pointer, String kind) {
    String inner = Document.below(pointer, kind);
    JsonNode value = yaml.root().at(inner);
    Map<String, Optional<String>> attributes = new LinkedHashMap<>();
    List<LaunchElement> children = new ArrayList<>(list(file, yaml, inner));
    children.addAll(list(file, yaml, Document.below(inner, CHILDREN)));
    value
        .properties()
        .forEach(
            each -> {
              if (each.getValue().isValueNode()) {
                attributes.put(each.getKey(), Optional.of(each.getValue().asText()));
              }
              boolean isList = each.getValue().isArray() && !each.getKey().equals(CHILDREN);
              for (JsonNode child : isList ? each.getValue() : List.<JsonNode>of()) {
                children.add(plain(each.getKey(), child, file, yaml.at(inner).line()));
              }
            });
    return new LaunchElement(
        kind.replace('-', '_'), attributes, children, file, yaml.at(inner).line());
  }

  private static LaunchElement plain(String kind, JsonNode value, String file, int line) {
    Map<String, Optional<String>> attributes = new LinkedHashMap<>();
    value
        .properties()
        .forEach(each -> attributes.put(each.getKey(), Optional.of(each.getValue().asText())));
    return new LaunchElement(kind, attributes, List.of(), file, line);
  }

  /** Returns the elements of a file in Python, as the reader of sources writes them. */
  public static List<LaunchElement> of(String file, JsonNode list) {
    List<LaunchElement> found = new ArrayList<>();
    list.forEach(each -> found.add(element(file, each)));
    return found;
  }

  private static LaunchElement element(String file, JsonNode json) {
    int line = json.path("line").asInt();
    Map<String, Optional<String>> attributes = new LinkedHashMap<>();
    json.path("attributes")
        .properties()
        .forEach(each -> attributes.put(each.getKey(), text(each.getValue())));
    attributes.put("text", text(json.path("text")));
    json.path("condition")
        .properties()
        .forEach(each -> attributes.put(each.getKey(), text(each.getValue())));
    List<LaunchElement> children = new ArrayList<>(of(file, json.path("children")));
    for (JsonNode pair : json.path("remaps")) {
      children.add(pair("remap", "from", "to", pair, file, line));
    }
    children.addAll(of(file, json.path("parameters")));
    for (JsonNode pair : json.path("arguments")) {
      children.add(pair("arg", "name", "value", pair, file, line));
    }
    return new LaunchElement(json.path("kind").asText(), attributes, children, file, line);
  }

  private static LaunchElement pair(
      String kind, String first, String second, JsonNode pair, String file, int line) {
    Map<String, Optional<String>> attributes = new LinkedHashMap<>();
    attributes.put(first, text(pair.path(0)));
    attributes.put(second, text(pair.path(1)));
    return new LaunchElement(kind, attributes, List.of(), file, line);
  }

  private static Optional<String> text(JsonNode value) {
    return value.isTextual() ? Optional.of(value.asText()) : Optional.empty();
  }

  /** Returns an attribute as it is written; empty if it is not there, or not known. */
  Optional<String> known(String attribute) {
    return attributes.getOrDefault(attribute, Optional.empty());
  }

  List<LaunchElement> children(String name) {
    return children.stream().filter(child -> child.kind().equals(name)).toList();
  }
}
