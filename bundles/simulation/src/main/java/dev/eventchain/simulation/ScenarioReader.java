package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.nodes.Node;

/** Reads scenario files. Units stand in the names of the keys and become SI units here. */
final class ScenarioReader {

  private static final double KMH = 1.0 / 3.6;
  private static final double MOST_SPEED_KMH = 250.0;

  private final SourceText text;
  private final List<Diagnostic> problems = new ArrayList<>();

  private ScenarioReader(SourceText text) {
    this.text = text;
  }

  static Scenario read(SourceText text) {
    ScenarioReader reader = new ScenarioReader(text);
    Optional<Node> root = reader.compose();
    Scenario scenario = root.map(reader::scenario).orElse(null);
    if (!reader.problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, reader.problems);
    }
    return scenario;
  }

  private Optional<Node> compose() {
    LoaderOptions options = new LoaderOptions();
    options.setMaxAliasesForCollections(0);
    try {
      Node root = new Yaml(options).compose(new StringReader(text.text()));
      if (root == null) {
        syntax("The file is empty.", SourceLocation.of(text.name()));
      }
      return Optional.ofNullable(root);
    } catch (MarkedYAMLException e) {
      SourceLocation location = YamlSection.locate(text, e.getProblemMark());
      syntax("This is no YAML: " + e.getProblem() + ".", location);
    } catch (YAMLException e) {
      syntax("This is no YAML: " + e.getMessage(), SourceLocation.of(text.name()));
    }
    return Optional.empty();
  }

  private void syntax(String message, SourceLocation location) {
    problems.add(Diagnostic.error("scenario.syntax", message, location));
  }

  private Scenario scenario(Node root) {
    YamlSection section = new YamlSection(text, root, "", problems);
    String name = section.requiredText("name");
    if (!name.matches("[a-z0-9]+(-[a-z0-9]+)*") && section.has("name")) {
      String message = "A name consists of lower-case letters, digits and hyphens.";
      section.problem("scenario.value.range", message, "name");
    }
    Scenario.Heading heading =
        new Scenario.Heading(
            name,
            section.requiredText("title"),
            section.text("description", "").strip(),
            section.texts("requirements"),
            section.location());
    long seed = (long) section.number("seed", 1, 0, 1L << 52);
    double duration = section.requiredNumber("duration_s", 0.1, 600);
    Optional<EgoVehicle> ego = section.requiredSection("ego").map(this::ego);
    List<TargetVehicle> targets = section.sections("targets").stream().map(this::target).toList();
    Optional<YamlSection> accept = section.requiredSection("accept");
    List<Criterion> criteria = accept.map(CriteriaReader::read).orElse(List.of());
    section.finish();
    EgoVehicle vehicle = ego.orElse(EgoVehicle.withSpeed(0));
    return new Scenario(heading, seed, duration, vehicle, targets, criteria);
  }

  private EgoVehicle ego(YamlSection section) {
    EgoVehicle usual = EgoVehicle.withSpeed(0);
    EgoVehicle ego =
        new EgoVehicle(
            section.requiredNumber("speed_kmh", 0, MOST_SPEED_KMH) * KMH,
            section.number("brake_delay_s", usual.brakeDelay(), 0, 5),
            section.number("brake_build_up_s", usual.brakeBuildUp(), 0, 5),
            section.number("maximal_deceleration_mps2", usual.maximalDeceleration(), 0.1, 20),
            section.number("coasting_deceleration_mps2", usual.coastingDeceleration(), 0, 5),
            section.number("lidar_behind_bumper_m", usual.lidarBehindBumper(), 0, 10),
            section.number("lidar_above_road_m", usual.lidarAboveRoad(), 0.5, 5),
            section.number("lidar_noise_m", usual.lidarNoise(), 0, 1));
    section.finish();
    return ego;
  }

  private TargetVehicle target(YamlSection section) {
    TargetVehicle usual = TargetVehicle.passengerCar(0, 0, 0);
    double deceleration = section.number("deceleration_mps2", 0, 0, 20);
    TargetVehicle target =
        new TargetVehicle(
            section.requiredNumber("gap_m", -500, 500),
            section.requiredNumber("speed_kmh", 0, MOST_SPEED_KMH) * KMH,
            section.number("lateral_offset_m", 0, -6, 6),
            section.number("width_m", usual.width(), 0.3, 3),
            section.number("height_m", usual.height(), 0.5, 4.5),
            section.number("length_m", usual.length(), 0.3, 30),
            section.number("brakes_at_s", Double.POSITIVE_INFINITY, 0, 600),
            deceleration);
    if (section.has("brakes_at_s") != section.has("deceleration_mps2")) {
      String present = section.has("brakes_at_s") ? "brakes_at_s" : "deceleration_mps2";
      section.problem(
          "scenario.value.range",
          "A vehicle that brakes needs both brakes_at_s and deceleration_mps2.",
          present);
    }
    section.finish();
    return target;
  }
}
