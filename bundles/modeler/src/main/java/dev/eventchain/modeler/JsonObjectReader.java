package dev.eventchain.modeler;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;

/** Reads the properties of one JSON object; whatever is not as it should be is a finding. */
final class JsonObjectReader {

  private final JsonText text;
  private final String pointer;
  private final JsonNode object;
  private final Consumer<Diagnostic> findings;
  private final Set<String> known = new TreeSet<>();

  private JsonObjectReader(
      JsonText text, String pointer, JsonNode object, Consumer<Diagnostic> findings) {
    this.text = text;
    this.pointer = pointer;
    this.object = object;
    this.findings = findings;
  }

  /** A reader of the object at a pointer; nothing if that is no object, which is a finding. */
  static Optional<JsonObjectReader> at(
      JsonText text, String pointer, Consumer<Diagnostic> findings) {
    JsonNode node = text.root().at(pointer);
    if (node.isObject()) {
      return Optional.of(new JsonObjectReader(text, pointer, node, findings));
    }
    findings.accept(
        Diagnostic.error(
            "modeler.value.type",
            "This must be an object, not " + kind(node) + ".",
            text.at(pointer)));
    return Optional.empty();
  }

  SourceLocation location() {
    return text.at(pointer);
  }

  String pointerTo(Object name) {
    return JsonText.below(pointer, name);
  }

  /** The place of a property, or of the object where the property is missing. */
  SourceLocation at(String name) {
    return text.at(pointerTo(name));
  }

  /** The property as it is; nothing where it is missing or null. */
  Optional<JsonNode> value(String name) {
    known.add(name);
    JsonNode value = object.get(name);
    return value == null || value.isNull() ? Optional.empty() : Optional.of(value);
  }

  /** A text; empty where it is missing, which is a finding. */
  String requiredText(String name) {
    Optional<String> value = text(name);
    if (value.isEmpty() || value.get().isBlank()) {
      boolean missing = !object.has(name);
      find(
          "modeler.feature.missing",
          "'" + name + "' is " + (missing ? "missing." : "empty."),
          missing ? location() : at(name));
    }
    return value.orElse("");
  }

  /** A text that may be missing. */
  Optional<String> text(String name) {
    Optional<JsonNode> value = value(name);
    if (value.isPresent() && !value.get().isTextual()) {
      findType(name, "a text", value.get());
      return Optional.empty();
    }
    return value.map(JsonNode::asText);
  }

  /** A finite number that is zero or more. */
  OptionalDouble number(String name) {
    return number(name, 0.0, "zero or more");
  }

  /** A finite number above zero. */
  OptionalDouble positiveNumber(String name) {
    return number(name, Double.MIN_VALUE, "above zero");
  }

  private OptionalDouble number(String name, double least, String range) {
    Optional<JsonNode> value = value(name);
    if (value.isEmpty()) {
      return OptionalDouble.empty();
    }
    if (!value.get().isNumber()) {
      findType(name, "a number", value.get());
      return OptionalDouble.empty();
    }
    double number = value.get().asDouble();
    if (!Double.isFinite(number) || number < least) {
      find(
          "modeler.value.range",
          "'%s' must be finite and %s, not %s.".formatted(name, range, value.get().asText()),
          at(name));
      return OptionalDouble.empty();
    }
    return OptionalDouble.of(number);
  }

  /** The texts of an array that may be missing. */
  List<String> texts(String name) {
    List<String> texts = new ArrayList<>();
    for (String element : elements(name)) {
      JsonNode value = text.root().at(element);
      if (value.isTextual()) {
        texts.add(value.asText());
      } else {
        find(
            "modeler.value.type",
            "This must be a text, not " + kind(value) + ".",
            text.at(element));
      }
    }
    return texts;
  }

  /** The pointers to the elements of an array that may be missing. */
  List<String> elements(String name) {
    Optional<JsonNode> value = value(name);
    if (value.isPresent() && !value.get().isArray()) {
      findType(name, "an array", value.get());
      return List.of();
    }
    List<String> pointers = new ArrayList<>();
    for (int i = 0; i < value.map(JsonNode::size).orElse(0); i++) {
      pointers.add(JsonText.below(pointerTo(name), i));
    }
    return pointers;
  }

  /** Reports the properties that nobody asked for. Called last. */
  void refuseOthers() {
    for (String name : (Iterable<String>) object::fieldNames) {
      if (!known.contains(name)) {
        findings.accept(
            Diagnostic.error(
                    "modeler.feature.unknown",
                    "There is no property '" + name + "' here.",
                    at(name))
                .withHint(NearestName.hint(name, known)));
      }
    }
  }

  void find(String id, String message, SourceLocation location) {
    findings.accept(Diagnostic.error(id, message, location));
  }

  private void findType(String name, String wanted, JsonNode value) {
    find(
        "modeler.value.type",
        "'" + name + "' must be " + wanted + ", not " + kind(value) + ".",
        at(name));
  }

  static String kind(JsonNode node) {
    return switch (node.getNodeType()) {
      case OBJECT -> "an object";
      case ARRAY -> "an array";
      case STRING -> "a text";
      case NUMBER -> "a number";
      case BOOLEAN -> "a truth value";
      case NULL -> "null";
      default -> "nothing";
    };
  }
}
