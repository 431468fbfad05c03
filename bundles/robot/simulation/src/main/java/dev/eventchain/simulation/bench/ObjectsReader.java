package dev.eventchain.simulation.bench;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.sensor.Listed;
import dev.eventchain.simulation.sensor.ObjectSensor;
import dev.eventchain.simulation.sensor.ObjectSensor.Column;
import dev.eventchain.simulation.sensor.ObjectSensor.Constant;
import dev.eventchain.simulation.sensor.ObjectSensor.Property;
import dev.eventchain.simulation.world.ActorKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads the section {@code objects} of a topic that is a list of objects. */
final class ObjectsReader {

  private static final NumberRange RANGE = NumberRange.of(1, 500);
  private static final NumberRange VIEW = NumberRange.of(1, 360);
  private static final NumberRange PERCENT = NumberRange.of(0, 100);
  private static final NumberRange NOISE = NumberRange.of(0, 1e6);

  private static final String FIELDS = "fields";
  private static final String COUNT = "count";
  private static final String CONSTANT = "constant";

  private final DeclaredSignals declared;
  private final String topic;
  private final Optional<MessageType> message;
  private final ListedFields listed;
  private final List<Column> columns = new ArrayList<>();
  private final List<Constant> constants = new ArrayList<>();

  /**
   * Creates a reader.
   *
   * @param message the type of the topic's messages, if known
   */
  ObjectsReader(DeclaredSignals declared, String topic, Optional<MessageType> message) {
    this.declared = declared;
    this.topic = topic;
    this.message = message;
    this.listed = new ListedFields(message);
  }

  ObjectSensor read(ObjectReader section) {
    double range = section.number("range_m", RANGE).orElse(150);
    double view = section.number("view_deg", VIEW).orElse(90);
    double missed = section.number("missed_percent", PERCENT).orElse(0);
    section
        .requiredObject(FIELDS)
        .ifPresent(part -> part.names().forEach(path -> field(part, path)));
    if (section.has(FIELDS) && section.value(FIELDS).map(JsonNode::isEmpty).orElse(false)) {
      section.find(BenchRules.BENCH_KEY_MISSING, "No field gets a value.", section.at(FIELDS));
    }
    Optional<String> count = section.text(COUNT).filter(path -> listed.counts(section, path));
    ObjectSensor sensor =
        new ObjectSensor(
            MountingReader.read(section),
            range,
            StrictMath.toRadians(view / 2),
            missed / 100,
            columns,
            constants,
            count);
    section.refuseOthers();
    return sensor;
  }

  private void field(ObjectReader part, String path) {
    if (!part.value(path).map(JsonNode::isObject).orElse(false)) {
      part.text(path)
          .flatMap(name -> property(part, path, name))
          .ifPresent(property -> column(part, path, property, Optional.empty(), 0.0, Map.of()));
      return;
    }
    ObjectReader section = part.object(path).orElseThrow();
    if (section.has(CONSTANT)) {
      constant(part, section, path);
    } else {
      column(part, section, path);
    }
    section.refuseOthers();
  }

  private void constant(ObjectReader part, ObjectReader section, String path) {
    Optional<Object> value =
        section
            .value(CONSTANT)
            .map(BenchFields::plain)
            .map(it -> FieldNames.numbered(it, FieldNames.ofListed(message, path)));
    if (value.isEmpty()) {
      section.find(BenchRules.BENCH_VALUE_RANGE, BenchFields.NO_VALUE, section.at(CONSTANT));
    } else if (!Listed.of(path).ofMessages()) {
      part.find(
          Diagnostic.of(
                  BenchRules.BENCH_VALUE_TYPE,
                  "'%s' is no field of messages in a list.".formatted(path),
                  part.at(path))
              .withHint("Give it its value in `fields` of the topic."));
    } else if (listed.takesValue(part, path, value.get(), section.at(CONSTANT))) {
      constants.add(new Constant(path, value.get()));
    }
  }

  private void column(ObjectReader part, ObjectReader section, String path) {
    Optional<Property> property =
        Optional.of(section.requiredText("value")).flatMap(name -> property(part, path, name));
    Optional<String> unit = section.text("unit");
    double noise = section.number("noise", NOISE).orElse(0);
    Map<ActorKind, Integer> classes =
        section
            .object("classes")
            .map(it -> ClassNumbers.read(it, FieldNames.ofListed(message, path)))
            .orElse(Map.of());
    property.ifPresent(it -> column(part, path, it, unit, noise, classes));
  }

  private void column(
      ObjectReader part,
      String path,
      Property property,
      Optional<String> unit,
      double noise,
      Map<ActorKind, Integer> classes) {
    if (property != Property.CLASS && !classes.isEmpty()) {
      part.find(BenchRules.BENCH_VALUE_RANGE, "Only `class` has classes.", part.at(path));
    } else if (listed.takes(part, path, property, !classes.isEmpty())
        && classes.values().stream()
            .distinct()
            .allMatch(number -> listed.takesValue(part, path, number, part.at(path)))) {
      Optional<String> text = unit.or(() -> declared.unit(topic, path));
      unit(part, path, property, text)
          .ifPresent(it -> columns.add(new Column(path, property, it, noise, classes)));
    }
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

  static boolean isFloat(FieldType type) {
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
}
