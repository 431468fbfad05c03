package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.VehicleReader;
import dev.eventchain.simulation.stage.PlayedFile;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Actuator;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.EgoMotion;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.HumanDriver;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Situation;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;

/** Reads the vehicle, its driver, the road and the actors of a scenario, and what they wait for. */
final class SituationReader {

  private static final NumberRange RADIUS = NumberRange.of(-100_000, 100_000);
  private static final double TIGHTEST = 30;

  private final ObjectReader section;
  private final SourceText text;
  private final Bench bench;
  private final ActorsReader reader;
  private final Set<String> awaited = new HashSet<>();

  /**
   * Creates a reader.
   *
   * @param section the whole scenario
   * @param text its file
   * @param longest its duration, in s
   */
  SituationReader(ObjectReader section, SourceText text, Bench bench, double longest) {
    this.section = section;
    this.text = text;
    this.bench = bench;
    this.reader = new ActorsReader(longest);
  }

  static List<String> names(List<Actor> actors) {
    return actors.stream().map(Actor::name).distinct().toList();
  }

  /** Returns the signals, of some, for which nothing waits. */
  Set<String> notAwaited(Collection<String> names) {
    Set<String> others = new TreeSet<>(names);
    others.removeAll(awaited);
    return others;
  }

  Situation read() {
    Optional<ObjectReader> part = section.requiredObject("ego");
    Road road = section.object("road").map(SituationReader::road).orElse(Road.straight());
    EgoVehicle ego = part.map(it -> ego(it, bench.vehicle(), road)).orElse(bench.vehicle());
    double offset = ego.chassis().offset();
    HumanDriver driver =
        part.map(it -> reader.driver(it, ego.speed(), offset))
            .orElse(Situation.straight(ego, List.of()).driver());
    part.ifPresent(it -> refuseWithoutEffect(it, ego));
    part.ifPresent(ObjectReader::refuseOthers);
    List<Actor> actors = reader.read(section);
    refuseOverlap(actors, ego, road);
    CircumstancesReader circumstances =
        new CircumstancesReader(text, bench.signals(), names(actors), List.of(), awaited);
    return new Situation(
        ego,
        part.map(it -> reader.completed(driver, it, circumstances)).orElse(driver),
        road,
        reader.completed(actors, circumstances),
        circumstances.read(section, "end_when").map(it -> it)); // as a predicate
  }

  /**
   * Reads what a scenario adds to what is played: the vehicle, and when it ends before its time.
   */
  Situation read(PlayedFile played) {
    OpenScenarioReader.ELSEWHERE.forEach(section::has); // refused with the file
    EgoVehicle usual = played.vehicle(bench.vehicle());
    EgoVehicle ego =
        section
            .object("ego")
            .map(
                part -> {
                  EgoVehicle own =
                      VehicleReader.read(part, usual, usual.speed(), ScenarioRules.VALUE_RANGE);
                  refuseWithoutEffect(part, own);
                  part.refuseOthers();
                  return own;
                })
            .orElse(usual);
    Situation situation = played.situation(ego, !section.has("duration_s"));
    CircumstancesReader circumstances =
        new CircumstancesReader(
            text, bench.signals(), names(situation.actors()), situation.events(), awaited);
    return new Situation(
        ego,
        situation.driver(),
        situation.road(),
        situation.actors(),
        circumstances.read(section, "end_when").map(it -> it),
        situation.director());
  }

  /** Refuses what a scenario says of a vehicle whose motion does not depend on it. */
  private void refuseWithoutEffect(ObjectReader part, EgoVehicle ego) {
    if (part.has(VehicleReader.SPEED_STEP)
        && ego.speedStep() > 0.0
        && bench.drives(Actuator.SPEED)) {
      part.find(
          Diagnostic.of(
                  ScenarioRules.VALUE_RANGE,
                  "The software commands the speed, which the vehicle follows continuously and not in"
                      + " steps.",
                  part.at(VehicleReader.SPEED_STEP))
              .withHint("Leave `speed_step_s` out."));
    }
    boolean turns = part.has(VehicleReader.YAW_RATE) && ego.chassis().turnsOnTheSpot();
    if (turns && !bench.drives(Actuator.YAW_RATE)) {
      part.find(
          Diagnostic.of(
                  ScenarioRules.VALUE_RANGE,
                  "The vehicle turns on the spot here, and no field of the bench drives its yaw_rate.",
                  part.at(VehicleReader.YAW_RATE))
              .withHint("Leave `maximal_yaw_rate_radps` out."));
    }
  }

  private void refuseOverlap(List<Actor> actors, EgoVehicle ego, Road road) {
    Body start = new EgoMotion(ego).body();
    for (Actor actor : actors) {
      if (actor.obstructs(ego.shape()) && start.separation(actor.body(road, 0)) < 0) {
        section.find(
            Diagnostic.of(
                    ScenarioRules.VALUE_RANGE,
                    "At the start, " + actor.name() + " and the ego are in the same place.",
                    reader.place(actor))
                .withHint(
                    "gap_m goes from the ego's front bumper to the rear of the other one; what is"
                        + " behind the ego or next to it needs room for both."));
      }
    }
  }

  private static Road road(ObjectReader section) {
    OptionalDouble radius = section.number("curve_radius_m", RADIUS);
    double width = VehicleReader.number(section, "lane_width_m", Road.USUAL_LANE_WIDTH, 2, 6);
    if (radius.isPresent() && Math.abs(radius.getAsDouble()) < TIGHTEST) {
      section.find(
          Diagnostic.of(
                  ScenarioRules.VALUE_RANGE,
                  "A bend has a radius of at least 30 m.",
                  section.at("curve_radius_m"))
              .withHint("To the right it is negative. Leave it out for a straight road."));
    }
    section.refuseOthers();
    return Road.bend(radius.isPresent() ? 1.0 / radius.getAsDouble() : 0.0, width);
  }

  private static EgoVehicle ego(ObjectReader section, EgoVehicle usual, Road road) {
    double speed =
        section.requiredNumber("speed_kmh", ManeuversReader.SPEED_KMH) * ActorsReader.KMH;
    EgoVehicle ego = VehicleReader.read(section, usual, speed, ScenarioRules.VALUE_RANGE);
    double offset = VehicleReader.number(section, "lateral_offset_m", 0, -6, 6);
    double along = ego.steadyHeading(road.curvature(0.0), offset);
    return ego.placed(offset, VehicleReader.radians(section, "heading_deg", along, -45, 45));
  }
}
