package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** A node of a StrictDoc document, in either of its formats. */
final class SdocNode {

  final String tag;
  final SourceLocation place;
  private final Map<String, String> fields = new LinkedHashMap<>();
  private final Map<String, SourceLocation> places = new LinkedHashMap<>();
  private final List<Relation> relations = new ArrayList<>();

  private record Relation(String type, String value, SourceLocation place) {}

  SdocNode(String tag, SourceLocation place) {
    this.tag = tag;
    this.place = place;
  }

  /** Keeps the first value of a field; returns false for a second one, which only comments have. */
  boolean put(String field, SourceLocation at, String value) {
    places.putIfAbsent(field, at);
    return fields.putIfAbsent(field, value) == null || field.equals("COMMENT");
  }

  void relate(String type, String value, SourceLocation at) {
    relations.add(new Relation(type, value, at));
  }

  String text(String field) {
    return fields.getOrDefault(field, "");
  }

  Map<String, SourceLocation> places() {
    return places;
  }

  void addTo(Reading reading) {
    RequirementSource.Fields names = reading.fields;
    Item item =
        new Item(
            text(names.id().orElse("UID")),
            text(names.text().orElse("STATEMENT")),
            places.getOrDefault(names.id().orElse("UID"), place));
    item.type = Optional.of(tag);
    item.status = Optional.of(text(names.status().orElse("STATUS"))).filter(s -> !s.isBlank());
    item.tags = Reading.parts(text(names.tags().orElse("TAGS")));
    for (Relation each : relations) {
      if (each.type().equals("Parent")) {
        item.addParent(each.value(), each.place());
      } else if (each.type().equals("Child")) {
        reading.addChild(item.id, each.value(), each.place());
      }
    }
    reading.items.add(item);
  }
}
