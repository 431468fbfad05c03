package dev.eventchain.simulation.bench;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.bench.Bench.Effect;
import dev.eventchain.simulation.world.Actuator;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Reads the effects of fields that the vehicle consumes. */
final class BenchEffects {

  private static final String OBSERVED = "observed";
  private static final String DRIVES = "drives";

  private final DeclaredSignals declared;
  private final BenchFields fields;

  BenchEffects(DeclaredSignals declared, BenchFields fields) {
    this.declared = declared;
    this.fields = fields;
  }

  /** Returns the effect of a consumed field; empty if it is invalid. */
  Optional<Effect> read(
      ObjectReader part, String topic, String path, Optional<MessageType> message) {
    Optional<FieldType> type = BenchFields.type(part, path, message);
    Optional<JsonNode> value = part.value(path);
    if (value.isEmpty()) {
      part.find(BenchRules.BENCH_VALUE_RANGE, BenchFields.NO_VALUE, part.at(path));
    }
    if (value.isEmpty() || (message.isPresent() && type.isEmpty())) {
      return Optional.empty();
    }
    if (!value.get().isObject()) {
      Optional<String> unit = unit(part, value.get(), topic, path);
      return part.text(path)
          .flatMap(name -> effect(part, path, name, unit, type))
          .map(it -> new Effect(path, it.actuator(), it.unit(), false, part.atKey(path)));
    }
    Optional<ObjectReader> section = part.object(path);
    return section.flatMap(
        it -> {
          Optional<String> unit = fields.unit(it, it.text("unit"), topic, path);
          boolean required = it.has("required");
          it.requireTrue("required");
          String name = it.requiredText(DRIVES);
          it.refuseOthers();
          return effect(it, DRIVES, name, unit, type)
              .map(
                  effect ->
                      new Effect(
                          path, effect.actuator(), effect.unit(), required, part.atKey(path)));
        });
  }

  /**
   * Returns the unit of a field; a field with an unknown unit may be observed but drives nothing.
   */
  private Optional<String> unit(ObjectReader part, JsonNode does, String topic, String path) {
    return does.asText().equals(OBSERVED)
        ? declared.unit(topic, path).filter(text -> Unit.parse(text).isPresent())
        : fields.unit(part, Optional.empty(), topic, path);
  }

  /** Actuator that a field drives, and its unit. */
  private record Driven(Optional<Actuator> actuator, String unit) {}

  /** Returns the actuator of an effect; empty if it is invalid. */
  private static Optional<Driven> effect(
      ObjectReader section,
      String key,
      String name,
      Optional<String> unitText,
      Optional<FieldType> type) {
    Optional<Actuator> actuator = Actuator.find(name);
    if (actuator.isEmpty() && !name.equals(OBSERVED)) {
      List<String> known = new ArrayList<>(Actuator.ids());
      known.add(OBSERVED);
      section.find(
          Diagnostic.of(
                  BenchRules.BENCH_ACTUATOR_UNKNOWN,
                  "The vehicle takes no '" + name + "'.",
                  section.at(key))
              .withHint(NearestName.hint(name, known)));
      return Optional.empty();
    }
    if (actuator.isEmpty()) {
      return Optional.of(new Driven(actuator, unitText.orElse("1")));
    }
    if (type.isPresent() && !BenchFields.takes(type.get(), actuator.get().truth())) {
      String wanted = actuator.get().truth() ? "true or false" : "a number";
      section.find(
          BenchRules.BENCH_VALUE_TYPE,
          "'" + name + "' is " + wanted + ", but the field is " + type.get() + ".",
          section.at(key));
      return Optional.empty();
    }
    return unitFits(section, key, actuator.get(), unitText)
        ? Optional.of(new Driven(actuator, unitText.orElse("1")))
        : Optional.empty();
  }

  private static boolean unitFits(
      ObjectReader section, String key, Actuator actuator, Optional<String> unitText) {
    Unit unit = Unit.parse(unitText.orElse("1")).orElseThrow();
    Unit.Relation relation = unit.relationTo(actuator.unit());
    boolean fits = relation == Unit.Relation.SAME || relation == Unit.Relation.CONVERTIBLE;
    if (!fits) {
      String found = unitText.map(text -> "in " + text).orElse("without a unit");
      section.find(
          BenchRules.BENCH_UNIT,
          "'%s' is in %s, but the field %s.".formatted(actuator.id(), actuator.unitText(), found),
          section.at(key));
    }
    return fits;
  }
}
