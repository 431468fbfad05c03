package dev.eventchain.simulation.stage;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.openscenario.document.ResolvedScenario;
import dev.eventchain.openscenario.document.ScenarioFile;
import dev.eventchain.openscenario.document.Variations;
import dev.eventchain.openscenario.storyboard.network.NetworkRoads;
import dev.eventchain.openscenario.storyboard.world.Entities;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import dev.eventchain.openscenario.storyboard.world.RouteSides;
import dev.eventchain.openscenario.storyboard.world.StraightRoad;
import dev.eventchain.roads.RoadNetwork;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** A scenario in OpenSCENARIO XML with values for its parameters, ready to be played. Immutable. */
public final class PlayedFile {

  /** Longest run of a storyboard that has a trigger to stop it, in s. */
  public static final double LONGEST = 300.0;

  private static final RoadMap NO_ROADS = new StraightRoad("", 0.0, 0, 0, 1.0);

  private final Stage stage;
  private final String file;
  private final String suffix;
  private final String words;
  private final List<Diagnostic> warnings;

  /**
   * Statements of a scenario about the file that it plays.
   *
   * @param parameters values for parameters, which no distribution may vary
   * @param ego the name of the vehicle with the software; empty: the one that is named so
   * @param routeSides which side positions on routes mean; empty: the usual one, with warnings
   */
  public record Choices(
      Map<String, String> parameters, Optional<String> ego, Optional<RouteSides> routeSides) {

    /** Copies the parameters. */
    public Choices {
      parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
    }
  }

  private PlayedFile(
      Stage stage, String file, String suffix, String words, List<Diagnostic> warnings) {
    this.stage = stage;
    this.file = file;
    this.warnings = List.copyOf(warnings);
    this.suffix = suffix;
    this.words = words;
  }

  /** Contents of a case: the scenario, and what is added to its name and its title. */
  private record Case(ResolvedScenario scenario, String file, String suffix, String words) {}

  /**
   * Reads a scenario, or the cases that a file of distributions has of one.
   *
   * @param place where the file is named
   * @param files what was read before
   * @throws DiagnosticException with all problems of the file, and of those that it leads to
   */
  public static List<PlayedFile> read(
      Path file, Choices choices, SourceLocation place, PlayedFiles files) {
    List<PlayedFile> played = new ArrayList<>();
    for (Case each : cases(file, choices.parameters(), files)) {
      played.add(played(each, files, choices, place));
    }
    return played;
  }

  /**
   * Reads all files that a scenario, or the cases of one, leads to, and plays nothing.
   *
   * @throws DiagnosticException as for {@link #read}
   */
  public static void visit(Path file, Map<String, String> parameters, PlayedFiles files) {
    cases(file, parameters, files)
        .forEach(each -> each.scenario().roadFile().ifPresent(files::network));
  }

  private static List<Case> cases(Path file, Map<String, String> parameters, PlayedFiles files) {
    ScenarioFile read = files.scenario(file);
    if (read.kind() == ScenarioFile.Kind.SCENARIO) {
      return List.of(of(read, parameters, "", ""));
    }
    Variations variations = Variations.of(read);
    Set<String> varied = varied(variations.cases());
    List<Case> cases = new ArrayList<>();
    int digits = String.valueOf(variations.cases().size()).length();
    for (Map<String, String> each : variations.cases()) {
      Map<String, String> values = new LinkedHashMap<>(parameters);
      values.putAll(each);
      String number = String.format(Locale.ROOT, "-%0" + digits + "d", cases.size() + 1);
      cases.add(of(variations.scenario(), values, number, words(each, varied)));
    }
    return cases;
  }

  private static Case of(
      ScenarioFile file, Map<String, String> parameters, String suffix, String words) {
    return new Case(file.resolve(parameters), file.path().getFileName().toString(), suffix, words);
  }

  private static PlayedFile played(
      Case own, PlayedFiles files, Choices choices, SourceLocation place) {
    ResolvedScenario scenario = own.scenario();
    Optional<RoadNetwork> network = scenario.roadFile().map(files::network);
    String name = ego(scenario, choices.ego(), place);
    Stage stage =
        new Stage(
            scenario,
            network,
            network.<RoadMap>map(NetworkRoads::new).orElse(NO_ROADS),
            name,
            choices.routeSides());
    List<Diagnostic> warnings = new ArrayList<>(scenario.warnings());
    network.ifPresent(roads -> warnings.addAll(roads.findings()));
    warnings.addAll(stage.findings());
    return new PlayedFile(stage, own.file(), own.suffix(), own.words(), warnings);
  }

  /** Returns the names of the parameters that differ between cases. */
  private static Set<String> varied(List<Map<String, String>> cases) {
    Set<String> varied = new TreeSet<>();
    for (Map<String, String> each : cases) {
      each.forEach(
          (name, value) -> {
            if (!value.equals(cases.get(0).get(name))) {
              varied.add(name);
            }
          });
    }
    return varied;
  }

  private static String words(Map<String, String> values, Set<String> varied) {
    List<String> words = new ArrayList<>();
    values.forEach(
        (name, value) -> {
          if (varied.contains(name)) {
            words.add(name + " = " + value);
          }
        });
    return words.isEmpty() ? "" : " (" + String.join(", ", words) + ")";
  }

  private static String ego(ResolvedScenario scenario, Optional<String> ego, SourceLocation place) {
    List<String> names = List.copyOf(Entities.of(scenario.root()).objects().keySet());
    List<String> found =
        names.stream()
            .filter(name -> ego.map(name::equals).orElse(name.equalsIgnoreCase("ego")))
            .toList();
    if (found.size() == 1) {
      return found.get(0);
    }
    String message =
        ego.map(name -> "There is no entity '" + name + "'.")
            .orElse("No entity is named Ego, so it is not known which one has the software.");
    String nearest = ego.map(name -> NearestName.hint(name, names)).orElse("");
    throw new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(StageRules.EGO, message, place)
            .withHint(
                nearest.isBlank()
                    ? "Name it with `ego`: " + String.join(", ", names) + "."
                    : nearest));
  }

  /** Returns what is added to the name of a scenario for a case; empty for the only one. */
  public String suffix() {
    return suffix;
  }

  /** Returns what is added to the title: the values that differ between cases. */
  public String words() {
    return words;
  }

  /** Returns what to know about the files, which does not keep it from being played. */
  public List<Diagnostic> warnings() {
    return warnings;
  }

  /** Returns whether a trigger stops the storyboard. */
  public boolean stops() {
    return stage.stops();
  }

  /** Returns the location of the trigger that stops the storyboard, or else of the storyboard. */
  public SourceLocation end() {
    return stage.end();
  }

  /** Returns the vehicle of a project with the body and the speed that the scenario gives it. */
  public EgoVehicle vehicle(EgoVehicle usual) {
    return stage.vehicle(usual);
  }

  /**
   * Returns the situation at the start.
   *
   * @param required whether the storyboard has to be at its end within {@link #LONGEST}
   */
  public Situation situation(EgoVehicle vehicle, boolean required) {
    int last = (int) (World.nanoseconds(LONGEST) / World.TRACE_STEP);
    return stage.situation(
        vehicle,
        Optional.of(new StoryboardDirector.Limit(last, "what stops the storyboard of " + file))
            .filter(limit -> required));
  }
}
