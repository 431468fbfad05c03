package dev.eventchain.simulation;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.FindingIds;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** Reads scenario files. Units stand in the names of the keys and become SI units here. */
final class ScenarioReader {

  private static final FindingIds IDS =
      new FindingIds(
          "scenario.syntax",
          "scenario.key.duplicate",
          "scenario.value.type",
          "scenario.key.missing",
          "scenario.key.unknown",
          "scenario.value.range");
  private static final double KMH = 1.0 / 3.6;
  private static final NumberRange SPEED_KMH = NumberRange.of(0, 250);
  private static final NumberRange DURATION = NumberRange.of(0.1, 600);
  private static final NumberRange SEED = NumberRange.of(0, 1L << 52);

  private ScenarioReader() {}

  static Scenario read(SourceText text, Bench bench) {
    List<Diagnostic> problems = new ArrayList<>();
    Document document = Document.parse(text, DocumentFormat.YAML, IDS, problems::add);
    Optional<Scenario> scenario =
        document.object("", problems::add).map(section -> scenario(section, text, bench));
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return scenario.orElseThrow();
  }

  private static Scenario scenario(ObjectReader section, SourceText text, Bench bench) {
    String name = section.requiredText("name");
    if (!name.matches("[a-z0-9]+(-[a-z0-9]+)*") && !name.isBlank()) {
      String message = "A name consists of lower-case letters, digits and hyphens.";
      section.find("scenario.value.range", message, section.at("name"));
    }
    Scenario.Heading heading =
        new Scenario.Heading(
            name,
            section.requiredText("title"),
            section.text("description").orElse("").strip(),
            section.texts("requirements"),
            section.has("requirements") ? section.atKey("requirements") : section.location(),
            section.location());
    long seed = section.wholeNumber("seed", SEED).orElse(1);
    double duration = section.requiredNumber("duration_s", DURATION);
    Optional<EgoVehicle> ego = section.requiredObject("ego").map(ScenarioReader::ego);
    List<TargetVehicle> targets =
        section.objects("targets").stream().map(ScenarioReader::target).toList();
    Map<String, Script> inputs =
        section.object("inputs").map(part -> InputsReader.read(part, bench)).orElse(Map.of());
    Optional<ObjectReader> accept = section.requiredObject("accept");
    FormulasReader formulas = new FormulasReader(text, bench.signals(), longest(section));
    List<Expectation> criteria =
        accept.map(part -> CriteriaReader.read(part, formulas)).orElse(List.of());
    InputsReader.requireUse(section, inputs.keySet(), criteria, bench);
    section.refuseOthers();
    EgoVehicle vehicle = ego.orElse(EgoVehicle.withSpeed(0));
    return new Scenario(heading, seed, duration, vehicle, targets, inputs, criteria);
  }

  /** The duration; if it was refused, the longest one, so that no interval is refused for it. */
  private static double longest(ObjectReader section) {
    return section
        .value("duration_s")
        .map(JsonNode::doubleValue)
        .filter(seconds -> seconds >= DURATION.least() && seconds <= DURATION.most())
        .orElse(DURATION.most());
  }

  private static EgoVehicle ego(ObjectReader section) {
    EgoVehicle usual = EgoVehicle.withSpeed(0);
    EgoVehicle ego =
        new EgoVehicle(
            section.requiredNumber("speed_kmh", SPEED_KMH) * KMH,
            number(section, "brake_delay_s", usual.brakeDelay(), 0, 5),
            number(section, "brake_build_up_s", usual.brakeBuildUp(), 0, 5),
            number(section, "maximal_deceleration_mps2", usual.maximalDeceleration(), 0.1, 20),
            number(section, "coasting_deceleration_mps2", usual.coastingDeceleration(), 0, 5),
            number(section, "maximal_acceleration_mps2", usual.maximalAcceleration(), 0, 20),
            number(section, "lidar_behind_bumper_m", usual.lidarBehindBumper(), 0, 10),
            number(section, "lidar_above_road_m", usual.lidarAboveRoad(), 0.5, 5),
            number(section, "lidar_noise_m", usual.lidarNoise(), 0, 1),
            chassis(section));
    section.refuseOthers();
    return ego;
  }

  private static Chassis chassis(ObjectReader section) {
    Chassis usual = Chassis.USUAL;
    return new Chassis(
        number(section, "wheelbase_m", usual.wheelbase(), 1, 10),
        radians(section, "maximal_steering_angle_deg", usual.maximalSteeringAngle(), 1, 60),
        number(section, "hand_brake_deceleration_mps2", usual.handBrakeDeceleration(), 0, 10),
        number(section, "drag_per_m", usual.drag(), 0, 0.01),
        number(section, "lateral_offset_m", usual.offset(), -6, 6),
        radians(section, "heading_deg", usual.heading(), -45, 45));
  }

  private static double radians(
      ObjectReader section, String key, double absent, double least, double most) {
    OptionalDouble degrees = section.number(key, NumberRange.of(least, most));
    return degrees.isPresent() ? StrictMath.toRadians(degrees.getAsDouble()) : absent;
  }

  private static TargetVehicle target(ObjectReader section) {
    TargetVehicle usual = TargetVehicle.passengerCar(0, 0, 0);
    double deceleration = number(section, "deceleration_mps2", 0, 0, 20);
    TargetVehicle target =
        new TargetVehicle(
            section.requiredNumber("gap_m", NumberRange.of(-500, 500)),
            section.requiredNumber("speed_kmh", SPEED_KMH) * KMH,
            number(section, "lateral_offset_m", 0, -6, 6),
            number(section, "width_m", usual.width(), 0.3, 3),
            number(section, "height_m", usual.height(), 0.5, 4.5),
            number(section, "length_m", usual.length(), 0.3, 30),
            number(section, "brakes_at_s", Double.POSITIVE_INFINITY, 0, 600),
            deceleration);
    if (section.has("brakes_at_s") != section.has("deceleration_mps2")) {
      String present = section.has("brakes_at_s") ? "brakes_at_s" : "deceleration_mps2";
      section.find(
          "scenario.value.range",
          "A vehicle that brakes needs both brakes_at_s and deceleration_mps2.",
          section.at(present));
    }
    section.refuseOthers();
    return target;
  }

  private static double number(
      ObjectReader section, String key, double absent, double least, double most) {
    return section.number(key, NumberRange.of(least, most)).orElse(absent);
  }
}
