package dev.eventchain.simulation.scenario;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.world.LateralProfile;
import dev.eventchain.simulation.world.Maneuver;
import dev.eventchain.simulation.world.SpeedProfile;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Reads the maneuvers of the driver or of an actor: first those at fixed times, then those that
 * begin by what happens or after the one before them.
 */
final class ManeuversReader {

  static final NumberRange SPEED_KMH = NumberRange.of(0, 250);
  static final NumberRange ASIDE = NumberRange.of(-50, 50);

  private static final Rule RANGE_FINDING = ScenarioRules.VALUE_RANGE;
  private static final NumberRange ACCELERATION = NumberRange.of(0.01, 20);
  private static final NumberRange LATERAL_SPEED = NumberRange.of(0.01, 5);
  private static final String KEY = "maneuvers";
  private static final String SPEED = "speed_kmh";
  private static final String OFFSET = "lateral_offset_m";
  private static final String ASIDE_RATE = "lateral_acceleration_mps2";
  private static final String AT = "at_s";
  private static final String AFTER = "after_s";
  private static final String WHEN = "when";

  private final ObjectReader section;
  private final double duration;

  /**
   * Creates a reader.
   *
   * @param section of the driver or of an actor
   * @param duration of the scenario, in s: later changes are rejected
   */
  ManeuversReader(ObjectReader section, double duration) {
    this.section = section;
    this.duration = duration;
  }

  private static boolean waits(ObjectReader maneuver) {
    return maneuver.has(WHEN) || maneuver.has(AFTER);
  }

  /** Returns whether a maneuver changes the offset. */
  boolean steer() {
    return section.objects(KEY).stream().anyMatch(each -> each.has(OFFSET));
  }

  private List<ObjectReader> timed(String key, String other) {
    return section.objects(KEY).stream()
        .filter(each -> !waits(each) && (each.has(key) || !each.has(other)))
        .toList();
  }

  /** Reads the changes of the speed at fixed times. */
  SpeedProfile speed(double start) {
    List<SpeedProfile.Change> changes = new ArrayList<>();
    double earliest = 0;
    for (ObjectReader each : timed(SPEED, OFFSET)) {
      double time = time(each, earliest);
      earliest = time;
      changes.add(speedChange(each, time));
      each.refuseOthers();
    }
    return new SpeedProfile(start, changes);
  }

  private static SpeedProfile.Change speedChange(ObjectReader each, double time) {
    double speed = each.requiredNumber(SPEED, SPEED_KMH) * ActorsReader.KMH;
    double rate = each.requiredNumber("acceleration_mps2", ACCELERATION);
    return new SpeedProfile.Change(time, speed, Math.max(rate, ACCELERATION.least()));
  }

  /** Reads the changes of the offset at fixed times. */
  LateralProfile line(double start, SpeedProfile speed) {
    List<LateralProfile.Change> changes = new ArrayList<>();
    for (ObjectReader each : timed(OFFSET, SPEED)) {
      if (!each.has(OFFSET)) {
        continue; // already reported: it is read as a change of the speed
      }
      double time = time(each, new LateralProfile(start, changes).end());
      changes.add(offsetChange(each, time));
      each.refuseOthers();
      if (speed.speed(time) == 0.0) {
        each.find(
            RANGE_FINDING, "It is standing still then, and cannot change lanes.", each.at(AT));
      }
    }
    return new LateralProfile(start, changes);
  }

  private static LateralProfile.Change offsetChange(ObjectReader each, double time) {
    double offset = each.requiredNumber(OFFSET, ASIDE);
    double rate = each.number("lateral_speed_mps", LATERAL_SPEED).orElse(1.5);
    boolean linear = each.text("shape").map(it -> isLinear(each, it)).orElse(false);
    double acceleration = each.number(ASIDE_RATE, ACCELERATION).orElse(Double.POSITIVE_INFINITY);
    if (!linear && each.has(ASIDE_RATE)) {
      each.find(
          Diagnostic.of(
                  RANGE_FINDING,
                  "The lateral speed of half a wave grows as that does.",
                  each.at(ASIDE_RATE))
              .withHint("Write `shape: linear` beside it, or leave it out."));
    }
    return new LateralProfile.Change(
        time, offset, rate, linear, Math.max(acceleration, ACCELERATION.least()));
  }

  private static boolean isLinear(ObjectReader each, String shape) {
    if (!shape.equals("linear") && !shape.equals("sinusoidal")) {
      each.find(
          Diagnostic.of(RANGE_FINDING, "'" + shape + "' is not allowed here.", each.at("shape"))
              .withHint("Use one of: linear, sinusoidal."));
    }
    return shape.equals("linear");
  }

  private double time(ObjectReader maneuver, double earliest) {
    double time = maneuver.requiredNumber(AT, NumberRange.of(0, duration));
    boolean isNumber = maneuver.value(AT).map(JsonNode::isNumber).orElse(false);
    if (isNumber && time < earliest) {
      String message =
          String.format(Locale.ROOT, "The previous one does not end until %.2f s.", earliest);
      maneuver.find(RANGE_FINDING, message, maneuver.at(AT));
    }
    return time;
  }

  /** Returns when the last maneuver of a fixed time begins, in s; 0 if there is none. */
  double begun() {
    return section.objects(KEY).stream()
        .filter(each -> !waits(each))
        .flatMap(each -> each.value(AT).stream())
        .mapToDouble(JsonNode::doubleValue)
        .max()
        .orElse(0);
  }

  /** Reads the maneuvers that begin by themselves, in their order. */
  List<Maneuver> waiting(CircumstancesReader circumstances) {
    List<Maneuver> waiting = new ArrayList<>();
    boolean waits = false;
    for (ObjectReader each : section.objects(KEY)) {
      if (waits(each)) {
        Optional<Maneuver.Start> start = start(each, circumstances);
        Maneuver.Change change = change(each);
        boolean optional = each.has("optional");
        each.requireTrue("optional");
        start.ifPresent(it -> waiting.add(new Maneuver(it, change, optional)));
        each.refuseOthers();
      } else if (waits && each.has(AT)) {
        each.find(
            Diagnostic.of(
                    RANGE_FINDING,
                    "The one before it begins by itself, so that this one cannot have a time.",
                    each.at(AT))
                .withHint("Put it first, or write after_s, from the begin of the one before it."));
      }
      waits |= waits(each);
    }
    return waiting;
  }

  private static Maneuver.Change change(ObjectReader each) {
    if (each.has(SPEED) && each.has(OFFSET)) {
      each.find(RANGE_FINDING, "One maneuver changes one of them.", each.at(OFFSET));
    }
    return each.has(OFFSET) ? offsetChange(each, 0) : speedChange(each, 0);
  }

  private Optional<Maneuver.Start> start(ObjectReader each, CircumstancesReader circumstances) {
    List<String> given = List.of(WHEN, AFTER, AT).stream().filter(each::has).toList();
    if (given.size() > 1) {
      String both = String.join(" and ", given.subList(0, 2));
      each.find(RANGE_FINDING, "It begins by one of " + both + ".", each.atKey(given.get(1)));
    }
    if (each.has(WHEN)) {
      return circumstances.read(each, WHEN).map(it -> new Maneuver.When(it.formula().text(), it));
    }
    double seconds = each.requiredNumber(AFTER, NumberRange.of(0, duration));
    return Optional.of(new Maneuver.After(World.nanoseconds(seconds)));
  }
}
