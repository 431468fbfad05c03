package dev.eventchain.simulation.scenario;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.VehicleReader;
import dev.eventchain.simulation.formula.ActorSignals;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.EgoMotion;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.HumanDriver;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Script;
import dev.eventchain.simulation.world.Situation;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;

/** Reads scenario files, with units in the names of the keys, into SI units. */
final class ScenarioReader {

  private static final DocumentRules RULES =
      new DocumentRules(
          ScenarioRules.SYNTAX,
          ScenarioRules.KEY_DUPLICATE,
          ScenarioRules.VALUE_TYPE,
          ScenarioRules.KEY_MISSING,
          ScenarioRules.KEY_UNKNOWN,
          ScenarioRules.VALUE_RANGE);
  private static final NumberRange RADIUS = NumberRange.of(-100_000, 100_000);
  private static final double TIGHTEST = 30;
  private static final NumberRange DURATION = NumberRange.of(0.1, 600);
  private static final NumberRange SEED = NumberRange.of(0, 1L << 52);

  private ScenarioReader() {}

  static Scenario read(SourceText text, Bench bench) {
    List<Diagnostic> problems = new ArrayList<>();
    Document document = Document.parse(text, DocumentFormat.YAML, RULES, problems::add);
    Optional<Scenario> scenario =
        document
            .object("", problems::add)
            .map(section -> scenario(section, text, bench, problems::isEmpty));
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return scenario.orElseThrow();
  }

  /**
   * Reads a scenario.
   *
   * @param sound returns whether there is no problem yet
   */
  private static Scenario scenario(
      ObjectReader section, SourceText text, Bench bench, BooleanSupplier sound) {
    String name = name(section);
    section.text("description"); // for people
    String title = section.requiredText("title");
    NamedRequirements requirements = NamedRequirements.ofScenario(section);
    long seed = section.wholeNumber("seed", SEED).orElse(1);
    double duration = section.requiredNumber("duration_s", DURATION);
    Set<String> awaited = new HashSet<>();
    Situation situation = situation(section, text, bench, awaited);
    Map<String, Script> inputs =
        section.object("inputs").map(part -> InputsReader.read(part, bench)).orElse(Map.of());
    FormulasReader formulas =
        new FormulasReader(
            text,
            new ActorSignals(bench.signals(), names(situation.actors())),
            longest(section),
            requirements,
            Optional.of(new SignalRanges(situation, inputs, bench, longest(section))));
    NodePhases phases = section.object("phases_ms").map(NodePhases::read).orElse(NodePhases.NONE);
    Scenario.Asked asked = asked(section, formulas);
    if (sound.getAsBoolean()) { // A criterion with an error may be the one that needs an input.
      Set<String> unread = new TreeSet<>(inputs.keySet());
      unread.removeAll(awaited);
      InputsReader.requireUse(section, unread, asked, bench);
    }
    section.refuseOthers();
    Scenario.Heading heading =
        new Scenario.Heading(
            name, title, requirements.all(), requirements.places(), section.location());
    return new Scenario(heading, seed, duration, situation, inputs, phases, asked);
  }

  private static Scenario.Asked asked(ObjectReader section, FormulasReader formulas) {
    List<Expectation> criteria =
        section
            .requiredObject("accept")
            .map(part -> CriteriaReader.read(part, formulas))
            .orElse(List.of());
    NamedRequirements requirements = formulas.requirements();
    return new Scenario.Asked(
        requirements.distributed(criteria),
        formulas.readObserved(section),
        requirements.judged(),
        formulas.optional().locations());
  }

  private static String name(ObjectReader section) {
    String name = section.requiredText("name");
    if (!name.matches("[a-z0-9]+(-[a-z0-9]+)*") && !name.isBlank()) {
      String message = "A name consists of lower-case letters, digits and hyphens.";
      section.find(ScenarioRules.VALUE_RANGE, message, section.at("name"));
    }
    return name;
  }

  private static List<String> names(List<Actor> actors) {
    return actors.stream().map(Actor::name).distinct().toList();
  }

  private static Situation situation(
      ObjectReader section, SourceText text, Bench bench, Set<String> awaited) {
    ActorsReader reader = new ActorsReader(longest(section));
    Optional<ObjectReader> part = section.requiredObject("ego");
    EgoVehicle ego = part.map(it -> ego(it, bench.vehicle())).orElse(bench.vehicle());
    double offset = ego.chassis().offset();
    HumanDriver driver =
        part.map(it -> reader.driver(it, ego.speed(), offset))
            .orElse(Situation.straight(ego, List.of()).driver());
    part.ifPresent(ObjectReader::refuseOthers);
    Road road = section.object("road").map(ScenarioReader::road).orElse(Road.STRAIGHT);
    List<Actor> actors = reader.read(section);
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
    CircumstancesReader circumstances =
        new CircumstancesReader(text, bench.signals(), names(actors), awaited);
    return new Situation(
        ego,
        part.map(it -> reader.completed(driver, it, circumstances)).orElse(driver),
        road,
        reader.completed(actors, circumstances),
        circumstances.read(section, "end_when").map(CircumstancesReader.Circumstance::condition));
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
    return new Road(radius.isPresent() ? 1.0 / radius.getAsDouble() : 0.0, width);
  }

  /**
   * Returns the duration; the maximum if it is invalid, so that no interval is rejected because of
   * it.
   */
  private static double longest(ObjectReader section) {
    return section
        .value("duration_s")
        .map(JsonNode::doubleValue)
        .filter(seconds -> seconds >= DURATION.least() && seconds <= DURATION.most())
        .orElse(DURATION.most());
  }

  private static EgoVehicle ego(ObjectReader section, EgoVehicle usual) {
    double speed =
        section.requiredNumber("speed_kmh", ManeuversReader.SPEED_KMH) * ActorsReader.KMH;
    return VehicleReader.read(section, usual, speed, ScenarioRules.VALUE_RANGE)
        .placed(
            VehicleReader.number(section, "lateral_offset_m", 0, -6, 6),
            VehicleReader.radians(section, "heading_deg", 0, -45, 45));
  }
}
