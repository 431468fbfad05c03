package dev.eventchain.project.requirements;

import static dev.eventchain.project.requirements.XhtmlText.name;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.XmlElement;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Reads the objects of a ReqIF file (OMG ReqIF 1.2), with the relations that tell parents. */
final class ReqIfReader {

  private static final Pattern ENCODING = Pattern.compile("<\\?xml[^>]*encoding=[\"']([^\"']+)");
  private static final List<String> IDS = List.of("ReqIF.ForeignID");
  private static final List<String> TEXTS = List.of("ReqIF.Text");
  private static final List<String> STATUSES = List.of("Status", "ReqIF.ForeignState");
  private static final List<String> TAGS = List.of("Tags");
  private static final String HEADING = "ReqIF.ChapterName";

  private final Reading reading;
  private final ReqIfTypes types;
  private final Map<String, Item> items = new HashMap<>();

  private ReqIfReader(ReqIfTypes types, Reading reading) {
    this.types = types;
    this.reading = reading;
  }

  static void read(SourceText source, Reading reading) {
    Matcher encoding = ENCODING.matcher(source.text());
    if (encoding.lookingAt() && !encoding.group(1).matches("(?i)utf-8|us-ascii")) {
      throw Reading.refused(
          "The file says that its encoding is " + encoding.group(1) + ".",
          source.at(0),
          "Export it in UTF-8.");
    }
    XmlElement root = XmlElement.parse(source, RequirementRules.SOURCE);
    XmlElement content =
        within(root, "CORE-CONTENT", "REQ-IF-CONTENT")
            .filter(each -> name(root).equals("REQ-IF"))
            .orElseThrow(
                () ->
                    Reading.refused(
                        "This is no ReqIF file: it has no REQ-IF with a REQ-IF-CONTENT.",
                        root.location(),
                        "Export it as ReqIF; RIF, which came before it, is not read."));
    new ReqIfReader(new ReqIfTypes(content), reading).read(content);
  }

  private void read(XmlElement content) {
    children(content, "SPEC-OBJECTS").forEach(this::object);
    children(content, "SPEC-RELATIONS").forEach(this::relation);
    children(content, "SPECIFICATIONS").forEach(each -> hierarchy(each, Optional.empty()));
  }

  private void object(XmlElement object) {
    RequirementSource.Fields names = reading.fields;
    ReqIfTypes.Values values = types.values(object);
    reading.findings.addAll(values.findings());
    String id = values.text(names.id(), IDS);
    ReqIfTypes.Value text = values.value(names.text(), TEXTS);
    Item item = new Item(id, text.plain(), object.location());
    item.type = types.nameOf(object);
    item.status = Optional.of(values.text(names.status(), STATUSES)).filter(s -> !s.isBlank());
    item.tags = Reading.parts(values.text(names.tags(), TAGS));
    if (item.text.isEmpty() && !values.text(Optional.empty(), List.of(HEADING)).isBlank()) {
      item.excluded = Optional.of("heading");
    }
    if (text.isReduced()) {
      reading.findings.add(
          Diagnostic.of(
                  RequirementRules.REDUCED,
                  "The text of " + id + " has objects, such as pictures, that are not read.",
                  object.location())
              .withHint("Say in words what they show, or see to it that nothing depends on them."));
    }
    reading.items.add(item);
    object.attribute("IDENTIFIER").ifPresent(key -> items.put(key, item));
  }

  private void relation(XmlElement relation) {
    boolean counts =
        reading.fields.parents().isEmpty()
            || types.nameOf(relation).filter(reading.fields.parents()::contains).isPresent();
    if (counts) {
      Item child = items.get(reference(relation, "SOURCE"));
      Item parent = items.get(reference(relation, "TARGET"));
      if (child == null || parent == null) {
        reading.findings.add(
            Diagnostic.of(
                RequirementRules.PARENT,
                "This relation names an object that the file does not have.",
                relation.location()));
      } else {
        child.addParent(parent.id, relation.location());
      }
    }
  }

  /** Adds the nearest object above each object that is no heading. */
  private void hierarchy(XmlElement node, Optional<Item> above) {
    for (XmlElement below : children(node, "CHILDREN").toList()) {
      Optional<Item> item = Optional.ofNullable(items.get(reference(below, "OBJECT")));
      SourceLocation place = below.location();
      if (item.isPresent() && above.isPresent()) {
        item.get().addParent(above.get().id, place);
      }
      hierarchy(below, item.filter(it -> it.excluded.isEmpty()).or(() -> above));
    }
  }

  /** Returns the text of the reference in a part; empty if there is none. */
  static String reference(XmlElement element, String part) {
    return children(element, part).map(XmlElement::text).findFirst().orElse("");
  }

  /** Returns the children of a child, whatever prefix its name has. */
  static Stream<XmlElement> children(XmlElement element, String part) {
    return element.children().stream()
        .filter(each -> name(each).equals(part))
        .flatMap(each -> each.children().stream());
  }

  private static Optional<XmlElement> within(XmlElement root, String outer, String inner) {
    return children(root, outer).filter(each -> name(each).equals(inner)).findFirst();
  }
}
