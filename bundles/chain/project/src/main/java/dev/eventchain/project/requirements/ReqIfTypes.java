package dev.eventchain.project.requirements;

import static dev.eventchain.project.requirements.ReqIfReader.children;
import static dev.eventchain.project.requirements.XhtmlText.name;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.documents.XmlElement;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** The types of a ReqIF file: their names, their attributes, and the names of enumerated values. */
final class ReqIfTypes {

  private final Map<String, XmlElement> types = new HashMap<>();
  private final Map<String, XmlElement> attributes = new HashMap<>();
  private final Map<String, String> enumerated = new HashMap<>();

  ReqIfTypes(XmlElement content) {
    children(content, "DATATYPES")
        .flatMap(datatype -> children(datatype, "SPECIFIED-VALUES"))
        .forEach(value -> enumerated.put(identifier(value), longName(value)));
    children(content, "SPEC-TYPES")
        .forEach(
            type -> {
              types.put(identifier(type), type);
              children(type, "SPEC-ATTRIBUTES")
                  .forEach(attribute -> attributes.put(identifier(attribute), attribute));
            });
  }

  /** A value of an attribute: its text, and whether a part of it is none. */
  record Value(String plain, boolean isReduced) {
    private static final Value NONE = new Value("", false);
  }

  /** The values of an object by the names of their attributes. */
  record Values(Map<String, Value> byName, List<Diagnostic> findings) {

    /** Returns the value of an attribute, or else of the first usual one with a text. */
    Value value(Optional<String> named, List<String> usual) {
      return named.map(List::of).orElse(usual).stream()
          .map(name -> byName.getOrDefault(name, Value.NONE))
          .filter(value -> !value.plain().isBlank())
          .findFirst()
          .orElse(Value.NONE);
    }

    String text(Optional<String> named, List<String> usual) {
      return value(named, usual).plain();
    }
  }

  /** Returns the name of the type of an object or relation. */
  Optional<String> nameOf(XmlElement typed) {
    return Optional.ofNullable(types.get(ReqIfReader.reference(typed, "TYPE")))
        .map(ReqIfTypes::longName);
  }

  /** Returns the values of an object, with the defaults of its type. */
  Values values(XmlElement object) {
    Map<String, Value> byName = new LinkedHashMap<>();
    List<Diagnostic> findings = new ArrayList<>();
    byName.put("IDENTIFIER", new Value(identifier(object), false));
    byName.put("LONG-NAME", new Value(longName(object), false));
    Optional.ofNullable(types.get(ReqIfReader.reference(object, "TYPE")))
        .ifPresentOrElse(
            type -> byName.putAll(defaults(type)),
            () -> findings.add(incomplete("The type of this object is not there.", object)));
    children(object, "VALUES")
        .forEach(
            value -> {
              XmlElement attribute = attributes.get(ReqIfReader.reference(value, "DEFINITION"));
              if (attribute == null) {
                findings.add(incomplete("The definition of this value is not there.", value));
              } else {
                byName.put(longName(attribute), read(value));
              }
            });
    return new Values(byName, findings);
  }

  private Map<String, Value> defaults(XmlElement type) {
    Map<String, Value> defaults = new LinkedHashMap<>();
    children(type, "SPEC-ATTRIBUTES")
        .forEach(
            attribute ->
                children(attribute, "DEFAULT-VALUE")
                    .forEach(value -> defaults.put(longName(attribute), read(value))));
    return defaults;
  }

  private static Diagnostic incomplete(String message, XmlElement place) {
    return Diagnostic.of(RequirementRules.SOURCE, message, place.location())
        .withHint("Export the types with the objects.");
  }

  /** Reads a value by its own kind; some tools write texts where XHTML is defined. */
  private Value read(XmlElement value) {
    return switch (name(value)) {
      case "ATTRIBUTE-VALUE-XHTML" -> xhtml(value);
      case "ATTRIBUTE-VALUE-ENUMERATION" ->
          new Value(
              children(value, "VALUES")
                  .map(each -> enumerated.getOrDefault(each.text(), each.text()))
                  .collect(Collectors.joining(", ")),
              false);
      default -> new Value(value.attribute("THE-VALUE").orElse(""), false);
    };
  }

  private static Value xhtml(XmlElement value) {
    boolean simplified =
        value.attribute("IS-SIMPLIFIED").filter(each -> each.matches("true|1")).isPresent();
    return value.children().stream()
        .filter(each -> name(each).equals("THE-VALUE"))
        .map(XhtmlText::of)
        .map(text -> new Value(text.text(), text.isReduced() || simplified))
        .findFirst()
        .orElse(Value.NONE);
  }

  private static String identifier(XmlElement element) {
    return element.attribute("IDENTIFIER").orElse("");
  }

  private static String longName(XmlElement element) {
    return element.attribute("LONG-NAME").orElse("");
  }
}
