package dev.eventchain.simulation.bench;

import dev.eventchain.messages.Unit;
import dev.eventchain.openscenario.storyboard.check.Feature;
import dev.eventchain.simulation.formula.ActorSignals;
import dev.eventchain.simulation.formula.Operator;
import dev.eventchain.simulation.formula.WorldSignals;
import dev.eventchain.simulation.sensor.ObjectSensor;
import dev.eventchain.simulation.world.Actuator;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Names of the world that benches and scenarios can use, for the documentation. */
public final class WorldReference {

  private WorldReference() {}

  /**
   * Something with a name.
   *
   * @param unit its unit; {@code 1} for a ratio, empty for a truth value
   */
  public record Entry(String name, String unit, String meaning) {}

  /**
   * An operator or a function of formulas.
   *
   * @param written how it is written, with operands
   * @param example a formula with it
   */
  public record OperatorEntry(String written, String meaning, String example) {}

  /** Returns the quantities and truth values of the world. */
  public static List<Entry> quantities() {
    return WorldSignals.all().stream()
        .map(it -> new Entry(it.name(), it.truth() ? "" : it.unit(), it.meaning()))
        .toList();
  }

  /** Returns the quantities of an actor, in formulas of scenarios. */
  public static List<Entry> actorQuantities() {
    return ActorSignals.quantities().stream()
        .map(it -> new Entry(it.name(), it.unit(), it.meaning()))
        .toList();
  }

  /** Returns what the object sensor knows of each object. */
  public static List<Entry> objectProperties() {
    return Arrays.stream(ObjectSensor.Property.values())
        .map(it -> new Entry(it.id(), it.unitText(), it.meaning()))
        .toList();
  }

  /** Returns what software can command of the vehicle. */
  public static List<Entry> actuators() {
    return Arrays.stream(Actuator.values())
        .map(it -> new Entry(it.id(), it.truth() ? "" : it.unitText(), it.meaning()))
        .toList();
  }

  /** Returns the units that people write most, those of the world, and the symbols of all. */
  public static List<String> units() {
    Stream<String> ofTheWorld =
        Stream.of(quantities(), actorQuantities(), objectProperties(), actuators())
            .flatMap(List::stream)
            .map(Entry::unit)
            .filter(unit -> !unit.isEmpty());
    return Stream.of(Unit.common().stream(), ofTheWorld, Unit.symbols().stream())
        .flatMap(units -> units)
        .distinct()
        .toList();
  }

  /** Returns the operators and functions of formulas. */
  public static List<OperatorEntry> operators() {
    return Arrays.stream(Operator.values())
        .map(it -> new OperatorEntry(it.written(), it.meaning(), it.example()))
        .toList();
  }

  /**
   * Elements, attributes and values of OpenSCENARIO XML of which the same is true.
   *
   * @param names {@code Element}, {@code Element@attribute} or {@code Element@attribute=value}, in
   *     code style
   * @param support {@code refused} or {@code no effect}
   */
  public record FeatureEntry(String names, String support, String reason) {}

  /** Returns what a storyboard may have by the standard, and is refused or has no effect. */
  public static List<FeatureEntry> unsupportedFeatures() {
    Map<List<String>, List<String>> names = new LinkedHashMap<>();
    for (Feature each : Feature.all().values()) {
      if (each.support() != Feature.Support.SUPPORTED) {
        String support = each.support() == Feature.Support.REFUSED ? "refused" : "no effect";
        names
            .computeIfAbsent(List.of(support, each.reason()), key -> new ArrayList<>())
            .add("`" + each.name() + "`");
      }
    }
    return names.entrySet().stream()
        .map(
            each ->
                new FeatureEntry(
                    String.join(", ", each.getValue()), each.getKey().get(0), each.getKey().get(1)))
        .toList();
  }
}
