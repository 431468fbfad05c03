package dev.eventchain.project.requirements;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.model.WrittenRequirement.Parent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads the JSON files of sphinx-needs and StrictDoc, which their keys tell apart. */
final class JsonItems {

  static final DocumentRules RULES = DocumentRules.all(RequirementRules.SOURCE);

  /** Lists of links to parents: those that people write, and the needs around a need. */
  private static final List<String> LINKS = List.of("links", "parent_needs");

  private final Document document;
  private final Reading reading;

  private JsonItems(Document document, Reading reading) {
    this.document = document;
    this.reading = reading;
  }

  static void read(SourceText source, Reading reading) {
    Document document =
        Document.parseWithAnyText(source, DocumentFormat.JSON, RULES, reading.findings::add);
    JsonItems items = new JsonItems(document, reading);
    if (document.root().path("versions").isObject()) {
      items.needs();
    } else if (document.root().path("DOCUMENTS").isArray()) {
      items.documents();
    } else {
      throw Reading.refused(
          "This is neither a needs.json of sphinx-needs nor a JSON export of StrictDoc.",
          source.at(0),
          "The first has 'versions', the second has 'DOCUMENTS'.");
    }
  }

  private void needs() {
    JsonNode versions = document.root().get("versions");
    String current = text(document.root().path("current_version"));
    if (current.isEmpty() && versions.size() == 1) {
      current = versions.fieldNames().next();
    }
    String pointer = Document.below("/versions", current);
    JsonNode needs = versions.path(current).path("needs");
    if (!needs.isObject()) {
      String message = "There are no needs of the current version, '" + current + "'.";
      throw Reading.refused(
          message, document.at(pointer), "'current_version' has to name one of 'versions'.");
    }
    for (Map.Entry<String, JsonNode> each : needs.properties()) {
      String place = Document.below(pointer + "/needs", each.getKey());
      if (each.getValue().isObject()) {
        need(each.getKey(), each.getValue(), place);
      } else {
        reading.unread(
            "This need must be an object.", document.atKey(place), "Export the needs again.");
      }
    }
    reading.items.forEach(item -> item.parents.replaceAll(parent -> whole(parent, needs)));
  }

  /** Returns the need of a link to a part of it, {@code ID.PART}, unless a need has this id. */
  private static Parent whole(Parent parent, JsonNode needs) {
    int dot = parent.id().lastIndexOf('.');
    boolean part = dot > 0 && !needs.has(parent.id()) && needs.has(parent.id().substring(0, dot));
    return part ? new Parent(parent.id().substring(0, dot), parent.location()) : parent;
  }

  private void need(String key, JsonNode need, String pointer) {
    RequirementSource.Fields names = reading.fields;
    SourceLocation place = document.atKey(pointer).withElement("");
    Item item =
        new Item(names.id().map(id -> text(need.path(id))).orElse(key), needText(need), place);
    item.type = present(need.path("type"));
    item.status = present(need.path(names.status().orElse("status")));
    item.tags = list(need.path(names.tags().orElse("tags")));
    if (need.path("is_external").asBoolean()) {
      item.excluded = Optional.of("of another project");
    }
    for (String link : names.parents().isEmpty() ? LINKS : names.parents()) {
      String at = Document.below(pointer, link);
      list(need.path(link)).forEach(id -> item.addParent(id, document.at(at).withElement("")));
    }
    reading.items.add(item);
  }

  /** Returns the text of a need; many consist of a title alone. */
  private String needText(JsonNode need) {
    if (reading.fields.text().isPresent()) {
      return text(need.path(reading.fields.text().get()));
    }
    for (String field : List.of("content", "description", "title")) {
      if (!text(need.path(field)).isBlank()) {
        return text(need.path(field));
      }
    }
    return "";
  }

  private void documents() {
    JsonNode documents = document.root().get("DOCUMENTS");
    for (int i = 0; i < documents.size(); i++) {
      nodes(documents.get(i), "/DOCUMENTS/" + i);
    }
  }

  private void nodes(JsonNode parent, String pointer) {
    JsonNode nodes = parent.path("NODES");
    for (int i = 0; i < nodes.size(); i++) {
      node(nodes.get(i), pointer + "/NODES/" + i);
    }
  }

  private void node(JsonNode json, String pointer) {
    String tag = text(json.path("_NODE_TYPE"));
    if (!json.isObject() || tag.isEmpty()) {
      reading.unread(
          "This node has no '_NODE_TYPE'.", document.at(pointer), "Export the document again.");
      return;
    }
    if (!SdocGrammar.STRUCTURE.contains(tag)) {
      SdocNode node = new SdocNode(tag, document.at(pointer).withElement(""));
      for (Map.Entry<String, JsonNode> field : json.properties()) {
        if (field.getValue().isTextual()) {
          SourceLocation at = document.atKey(Document.below(pointer, field.getKey()));
          node.put(field.getKey(), at.withElement(""), field.getValue().textValue());
        }
      }
      JsonNode relations = json.path("RELATIONS");
      for (int i = 0; i < relations.size(); i++) {
        SourceLocation at = document.at(pointer + "/RELATIONS/" + i).withElement("");
        node.relate(text(relations.get(i).path("TYPE")), text(relations.get(i).path("VALUE")), at);
      }
      node.addTo(reading);
    }
    nodes(json, pointer);
  }

  private static Optional<String> present(JsonNode value) {
    return Optional.of(text(value)).filter(text -> !text.isBlank());
  }

  /** Returns the texts of an array, or of a text that lists them. */
  private static List<String> list(JsonNode value) {
    if (value.isTextual()) {
      return Reading.parts(value.textValue());
    }
    List<String> all = new ArrayList<>();
    value.forEach(each -> all.add(text(each)));
    return all.stream().filter(each -> !each.isBlank()).toList();
  }

  private static String text(JsonNode value) {
    return value.isValueNode() && !value.isNull() ? value.asText() : "";
  }
}
