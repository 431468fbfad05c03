package dev.eventchain.simulation.bench;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.sensor.ObjectSensor;
import dev.eventchain.simulation.sensor.ObjectSensor.Column;
import dev.eventchain.simulation.sensor.ObjectSensor.Property;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Reads the section {@code objects} of a topic that is a list of objects. */
final class ObjectsReader {

  private static final NumberRange RANGE = NumberRange.of(1, 500);
  private static final NumberRange VIEW = NumberRange.of(1, 180);
  private static final NumberRange PERCENT = NumberRange.of(0, 100);
  private static final NumberRange NOISE = NumberRange.of(0, 1e6);

  private final DeclaredSignals declared;
  private final String topic;
  private final Optional<MessageType> message;

  /**
   * Creates a reader.
   *
   * @param message the type of the topic's messages, if known
   */
  ObjectsReader(DeclaredSignals declared, String topic, Optional<MessageType> message) {
    this.declared = declared;
    this.topic = topic;
    this.message = message;
  }

  ObjectSensor read(ObjectReader section) {
    double range = section.number("range_m", RANGE).orElse(150);
    double view = section.number("view_deg", VIEW).orElse(90);
    double missed = section.number("missed_percent", PERCENT).orElse(0);
    List<Column> columns = new ArrayList<>();
    section
        .requiredObject("fields")
        .ifPresent(
            part -> part.names().forEach(path -> column(part, path).ifPresent(columns::add)));
    if (section.has("fields") && section.value("fields").map(JsonNode::isEmpty).orElse(false)) {
      section.find(BenchRules.BENCH_KEY_MISSING, "No field gets a value.", section.at("fields"));
    }
    section.refuseOthers();
    return new ObjectSensor(range, StrictMath.toRadians(view / 2), missed / 100, columns);
  }

  private Optional<Column> column(ObjectReader part, String path) {
    Optional<String> written = Optional.empty();
    double noise = 0.0;
    Optional<String> name;
    if (part.value(path).map(JsonNode::isObject).orElse(false)) {
      ObjectReader section = part.object(path).orElseThrow();
      name = Optional.of(section.requiredText("value"));
      written = section.text("unit");
      noise = section.number("noise", NOISE).orElse(0);
      section.refuseOthers();
    } else {
      name = part.text(path);
    }
    Optional<Property> property = name.flatMap(it -> property(part, path, it));
    boolean fits = property.isPresent() && fits(part, path, property.get() == Property.ID);
    double deviation = noise;
    Optional<String> text = written.or(() -> declared.unit(topic, path));
    return property
        .filter(it -> fits)
        .flatMap(
            it -> unit(part, path, it, text).map(unit -> new Column(path, it, unit, deviation)));
  }

  private static Optional<Property> property(ObjectReader part, String path, String name) {
    Optional<Property> property = Property.find(name);
    if (property.isEmpty()) {
      part.find(
          Diagnostic.of(
                  BenchRules.BENCH_VALUE_RANGE, "An object has no '" + name + "'.", part.at(path))
              .withHint(
                  NearestName.of(name, Property.ids())
                      .map(near -> "Did you mean '" + near + "'?")
                      .orElse("It has: " + String.join(", ", Property.ids()) + ".")));
    }
    return property;
  }

  private static boolean isFloat(FieldType type) {
    return type.kind() == FieldType.Kind.FLOAT32 || type.kind() == FieldType.Kind.FLOAT64;
  }

  private static Optional<Unit> unit(
      ObjectReader part, String path, Property property, Optional<String> text) {
    Optional<Unit> unit = Unit.parse(text.orElse(property.unitText()));
    boolean fits =
        unit.map(it -> it.relationTo(property.unit()))
            .filter(it -> it == Unit.Relation.SAME || it == Unit.Relation.CONVERTIBLE)
            .isPresent();
    if (!fits) {
      part.find(
          BenchRules.BENCH_UNIT,
          "'%s' cannot be sent in %s.".formatted(property.id(), text.orElse("")),
          part.at(path));
    }
    return unit.filter(it -> fits);
  }

  /** Checks that a field is a sequence of numbers of the right kind. */
  private boolean fits(ObjectReader part, String path, boolean isId) {
    if (message.isEmpty()) {
      return true;
    }
    MessageType.Resolution found = message.get().resolve(path);
    if (found.type().isEmpty()) {
      part.find(
          Diagnostic.of(BenchRules.MESSAGE_FIELD_MISSING, found.problem(), part.atKey(path))
              .withHint(found.hint()));
      return false;
    }
    FieldType type = found.type().get();
    boolean numbers =
        type.shape() == FieldType.Shape.SEQUENCE && type.size() == 0 && isFloat(type) != isId;
    if (!numbers) {
      part.find(
          Diagnostic.of(
                  BenchRules.BENCH_VALUE_TYPE,
                  "'%s' is %s, but here it has to be %s."
                      .formatted(path, type, isId ? "uint32[]" : "float32[] or float64[]"),
                  part.atKey(path))
              .withHint("Each field of a list of objects holds a number for each of them."));
    }
    return numbers;
  }
}
