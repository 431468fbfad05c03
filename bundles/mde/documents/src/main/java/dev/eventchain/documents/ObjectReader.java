package dev.eventchain.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Reader of one object of a document (a mapping in YAML), key by key. Invalid content is a finding,
 * after which reading continues.
 *
 * <p>A value of the wrong type is never converted. In JSON, {@code null} counts as absent; in YAML
 * it is a finding.
 */
public final class ObjectReader {

  private final Document document;
  private final String pointer;
  private final JsonNode object;
  private final Consumer<Diagnostic> findings;
  private final Set<String> known = new LinkedHashSet<>();

  ObjectReader(Document document, String pointer, JsonNode object, Consumer<Diagnostic> findings) {
    this.document = document;
    this.pointer = pointer;
    this.object = object;
    this.findings = findings;
  }

  /** Returns the location where the object begins. */
  public SourceLocation location() {
    return document.at(pointer);
  }

  /** Returns the pointer to the value of a key. */
  public String pointerTo(Object name) {
    return Document.below(pointer, name);
  }

  /** Returns the location of the value of a key, or of the object if the key is missing. */
  public SourceLocation at(String name) {
    return document.at(pointerTo(name));
  }

  /** Returns the location of a key, or of the object if the key is missing. */
  public SourceLocation atKey(String name) {
    return document.atKey(pointerTo(name));
  }

  /** Returns whether the key is present, with or without a value. */
  public boolean has(String name) {
    known.add(name);
    return object.has(name);
  }

  /** Returns the keys, in the order of the file. */
  public List<String> names() {
    List<String> names = new ArrayList<>();
    object.fieldNames().forEachRemaining(names::add);
    return names;
  }

  /** Returns the raw value; empty if it is missing or null. */
  public Optional<JsonNode> value(String name) {
    known.add(name);
    JsonNode value = object.get(name);
    return value == null || value.isNull() ? Optional.empty() : Optional.of(value);
  }

  /** Returns the value of a key. A null value in YAML is a finding. */
  private Optional<JsonNode> given(String name, String wanted) {
    Optional<JsonNode> value = value(name);
    if (value.isEmpty() && object.has(name) && document.format() == DocumentFormat.YAML) {
      refuseType(name, wanted);
    }
    return value;
  }

  /** Reports that a key is missing, unless it has an invalid value, which was reported. */
  private void require(String name) {
    if (!object.has(name)) {
      find(document.rules().missing(), "'" + name + "' is missing.", location());
    } else if (object.get(name).isNull() && document.format() == DocumentFormat.JSON) {
      find(document.rules().missing(), "'" + name + "' is empty.", at(name));
    }
  }

  /** Returns a text that is not blank; empty, with a finding, if it is missing. */
  public String requiredText(String name) {
    Optional<String> value = text(name);
    require(name);
    if (value.isPresent() && value.get().isBlank()) {
      find(document.rules().missing(), "'" + name + "' is empty.", at(name));
    }
    return value.orElse("");
  }

  /** Returns an optional text. */
  public Optional<String> text(String name) {
    Optional<JsonNode> value = given(name, "a string");
    if (value.isPresent() && !value.get().isTextual()) {
      refuseType(name, "a string");
      return Optional.empty();
    }
    return value.map(JsonNode::textValue);
  }

  /** Returns a number; the lower bound, with a finding, if it is missing or invalid. */
  public double requiredNumber(String name, NumberRange range) {
    OptionalDouble value = number(name, range);
    require(name);
    return value.orElse(range.least());
  }

  /** Returns an optional number. */
  public OptionalDouble number(String name, NumberRange range) {
    Optional<JsonNode> value = given(name, "a number");
    if (value.isEmpty()) {
      return OptionalDouble.empty();
    }
    if (!value.get().isNumber()) {
      refuseType(name, "a number");
      return OptionalDouble.empty();
    }
    double number = value.get().doubleValue();
    return isIn(name, number, range) ? OptionalDouble.of(number) : OptionalDouble.empty();
  }

  /** Returns an optional whole number. */
  public OptionalLong wholeNumber(String name, NumberRange range) {
    Optional<JsonNode> value = given(name, "a whole number");
    if (value.isEmpty()) {
      return OptionalLong.empty();
    }
    if (!value.get().isIntegralNumber()) {
      refuseType(name, "a whole number");
      return OptionalLong.empty();
    }
    return isIn(name, value.get().doubleValue(), range) && value.get().canConvertToLong()
        ? OptionalLong.of(value.get().longValue())
        : OptionalLong.empty();
  }

  /** Returns a whole number; the lower bound, with a finding, if it is missing or invalid. */
  public long requiredWholeNumber(String name, NumberRange range) {
    OptionalLong value = wholeNumber(name, range);
    require(name);
    return value.orElse((long) range.least());
  }

  private boolean isIn(String name, double number, NumberRange range) {
    if (!range.holds(number)) {
      String message =
          String.format(
              "'%s' must be %s, not %s.", name, range.words(), shortened(object.get(name)));
      find(document.rules().range(), message, at(name));
    }
    return range.holds(number);
  }

  /** Reports a finding unless a key is {@code true} or absent. */
  public void requireTrue(String name) {
    Optional<JsonNode> value = given(name, "true");
    if (value.isPresent() && !(value.get().isBoolean() && value.get().booleanValue())) {
      findings.accept(
          Diagnostic.of(document.rules().type(), wrong(name, "true"), at(name))
              .withHint("Write true, or leave the " + document.format().key() + " out."));
    }
  }

  /** Returns the texts of an optional array. */
  public List<String> texts(String name) {
    List<String> texts = new ArrayList<>();
    JsonNode array = array(name);
    for (int i = 0; i < array.size(); i++) {
      JsonNode value = array.get(i);
      if (value.isTextual()) {
        texts.add(value.textValue());
      } else {
        String message = "This must be a string, not " + shown(value) + ".";
        findings.accept(
            Diagnostic.of(
                    document.rules().type(),
                    message,
                    document.at(Document.below(pointerTo(name), i)))
                .withHint(TypeHint.of("a string", value)));
      }
    }
    return texts;
  }

  private JsonNode array(String name) {
    String wanted = document.format().array();
    Optional<JsonNode> value = given(name, wanted);
    if (value.isPresent() && !value.get().isArray()) {
      refuseType(name, wanted);
    }
    return value.filter(JsonNode::isArray).orElse(MissingNode.getInstance());
  }

  /** Returns a reader of an optional object. */
  public Optional<ObjectReader> object(String name) {
    String wanted = document.format().object();
    Optional<JsonNode> value = given(name, wanted);
    if (value.isPresent() && !value.get().isObject()) {
      refuseType(name, wanted);
      return Optional.empty();
    }
    return value.map(node -> new ObjectReader(document, pointerTo(name), node, findings));
  }

  /** Returns a reader of a required object. */
  public Optional<ObjectReader> requiredObject(String name) {
    Optional<ObjectReader> found = object(name);
    require(name);
    return found;
  }

  /** Returns readers of the objects of an optional array. */
  public List<ObjectReader> objects(String name) {
    return document.objects(pointerTo(name), array(name), findings);
  }

  /** Returns readers of the objects of a required array. */
  public List<ObjectReader> requiredObjects(String name) {
    List<ObjectReader> found = objects(name);
    require(name);
    return found;
  }

  /** Reports the keys that were not read. Must be called last. */
  public void refuseOthers() {
    for (String name : names()) {
      if (!known.contains(name)) {
        String message = "There is no " + document.format().key() + " '" + name + "' here.";
        findings.accept(
            Diagnostic.of(document.rules().unknown(), message, atKey(name))
                .withHint(NearestName.hint(name, known)));
      }
    }
  }

  /** Reports another finding about the object. */
  public void find(Rule rule, String message, SourceLocation location) {
    find(Diagnostic.of(rule, message, location));
  }

  /** Reports another finding about the object. */
  public void find(Diagnostic finding) {
    findings.accept(finding);
  }

  /**
   * Reports a value of the wrong type.
   *
   * @param wanted the required type: "a string"
   */
  public void refuseType(String name, String wanted) {
    findings.accept(
        Diagnostic.of(document.rules().type(), wrong(name, wanted), at(name))
            .withHint(TypeHint.of(wanted, object.get(name))));
  }

  private String wrong(String name, String wanted) {
    JsonNode value = object.get(name);
    String found = value.isNull() ? "but there is nothing here" : "not " + shown(value);
    return "'" + name + "' must be " + wanted + ", " + found + ".";
  }

  private static String shortened(JsonNode value) {
    String text = value.toString();
    return text.length() > 60 ? text.substring(0, 60) + "..." : text;
  }

  /** Returns the kind of a value, with the value itself if it is short. */
  private String shown(JsonNode value) {
    String kind = document.kind(value);
    if (!value.isValueNode() || value.isNull()) {
      return kind;
    }
    return kind + " " + shortened(value);
  }
}
