package dev.eventchain.simulation.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Chassis;
import dev.eventchain.simulation.world.EgoVehicle;
import dev.eventchain.simulation.world.LidarSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ScenarioTest {

  private static final String EXPECT = "# expect: ";

  @TempDir Path folder;

  static List<Path> invalidScenarios() throws IOException {
    try (Stream<Path> files = Files.list(Path.of("src/test/resources/invalid-scenarios"))) {
      return files.sorted().toList();
    }
  }

  /** The first lines of each file list its findings: id, line, column and pointer. */
  @ParameterizedTest
  @MethodSource("invalidScenarios")
  void everyProblemOfAnInvalidScenarioIsFoundAtItsPlace(Path file) throws IOException {
    DiagnosticException failure =
        assertThrows(DiagnosticException.class, () -> Scenario.read(file, Bench.carla()));
    assertEquals(DiagnosticException.Reason.INPUT, failure.reason());
    List<String> expected =
        Files.readAllLines(file).stream()
            .filter(line -> line.startsWith(EXPECT))
            .map(line -> line.substring(EXPECT.length()))
            .toList();
    assertEquals(expected, failure.diagnostics().stream().map(ScenarioTest::describe).toList());
  }

  private static String describe(Diagnostic problem) {
    String place = problem.location().line() + ":" + problem.location().column();
    return (problem.id() + " " + place + " " + problem.location().element()).strip();
  }

  @Test
  void unitsOfTheKeysBecomeSiUnits() {
    Scenario scenario =
        Scenario.parse(
            SourceText.of(
                "s.yaml",
                """
                name: all-keys
                title: All keys
                description: Every key that there is.
                requirements: [AEB-1, AEB-2]
                seed: 42
                duration_s: 7.5
                ego:
                  speed_kmh: 36
                  brake_delay_s: 0.1
                  brake_build_up_s: 0.4
                  maximal_deceleration_mps2: 8
                  coasting_deceleration_mps2: 0.3
                  lidar_behind_bumper_m: 1.5
                  lidar_above_road_m: 2
                  lidar_noise_m: 0.02
                actors:
                  - gap_m: 40
                    speed_kmh: 18
                    lateral_offset_m: -3.5
                    width_m: 2.5
                    height_m: 4
                    length_m: 12
                    maneuvers:
                      - at_s: 2
                        speed_kmh: 0
                        acceleration_mps2: 6
                accept:
                  maximal_impact_speed_kmh: 18
                  tolerance_ttc_s: 0.2
                  tolerance_reaction_s: 0.4
                """),
            Bench.carla());
    assertEquals(
        new EgoVehicle(
            10, 0.1, 0.4, 8, 0.3, 3, new LidarSettings(1.5, 2, 0.02, 0, 0.5), Chassis.USUAL),
        scenario.situation().ego());
    Actor actor = scenario.situation().actors().get(0);
    assertEquals(new Actor.Size(12, 2.5, 0, 4), actor.size());
    assertEquals(40 + 10, actor.rear(2), 1e-9);
    assertEquals(-3.5, actor.across(2), 1e-9);
    assertEquals(0, actor.speedAlong(3), 1e-9);
    assertEquals(List.of("AEB-1", "AEB-2"), scenario.requirements());
    assertEquals(7.5, scenario.duration());
    assertEquals(42, scenario.seed());
    Criterion impact = (Criterion) scenario.criteria().get(0);
    assertEquals(5, impact.limit(), 1e-12);
    assertEquals(new Criterion.Tolerances(0.2, 0.4), impact.tolerances());
    assertEquals("s.yaml:28:3", impact.location().toString());
  }

  @Test
  void everyScenarioAsksForCommandsThatArriveAndAreNormalized() {
    for (Scenario scenario : AebProject.scenarios()) {
      List<CriterionKind> kinds =
          scenario.criteria().stream()
              .filter(Criterion.class::isInstance)
              .map(each -> ((Criterion) each).kind())
              .toList();
      assertTrue(kinds.contains(CriterionKind.BRAKE_NORMALIZED));
      assertTrue(kinds.contains(CriterionKind.COMMANDS_ARRIVE));
    }
  }

  @Test
  void folderIsReadInTheOrderOfTheNamesAndTellsEveryProblem() throws IOException {
    Files.writeString(folder.resolve("b.yaml"), "name: 1");
    Files.writeString(folder.resolve("a.yaml"), "- x");
    DiagnosticException failure = assertThrows(DiagnosticException.class, () -> read(folder));
    List<String> files =
        failure.diagnostics().stream()
            .map(problem -> Path.of(problem.location().file()).getFileName().toString())
            .distinct()
            .toList();
    assertEquals(List.of("a.yaml", "b.yaml"), files);
  }

  @Test
  void folderWithoutScenariosChecksNothingAndSaysSo() {
    for (Path place : List.of(folder, folder.resolve("missing"))) {
      DiagnosticException failure = assertThrows(DiagnosticException.class, () -> read(place));
      assertEquals("scenario.none", failure.diagnostics().get(0).id());
    }
  }

  @Test
  void twoScenariosOfOneNameAreRefused() throws IOException {
    Path original = AebProject.EXAMPLE.resolve("scenarios/empty-road.yaml");
    Files.copy(original, folder.resolve("a.yaml"));
    Files.copy(original, folder.resolve("b.yaml"));
    DiagnosticException failure = assertThrows(DiagnosticException.class, () -> read(folder));
    assertEquals("scenario.name.duplicate", failure.diagnostics().get(0).id());
    assertTrue(failure.diagnostics().get(0).message().contains("a.yaml"));
  }

  @Test
  void everyYamlFileBelowTheFolderCountsInTheOrderOfThePaths() throws IOException {
    List<String> paths = List.of("B.YAML", "a/x.yml", "a/y/z.Yaml", "c.yaml", "linked/l.yaml");
    Path elsewhere = Files.createDirectories(folder.resolve("elsewhere"));
    Path scenarios = Files.createDirectories(folder.resolve("scenarios"));
    Files.createSymbolicLink(scenarios.resolve("linked"), elsewhere);
    for (int i = 0; i < paths.size(); i++) {
      scenario(scenarios.resolve(paths.get(i)), "scenario-" + i);
    }
    scenario(scenarios.resolve(".hidden/h.yaml"), "hidden");
    scenario(scenarios.resolve("d.yaml~"), "backup");
    Files.writeString(scenarios.resolve("notes.txt"), "notes");
    List<Diagnostic> warnings = new ArrayList<>();
    List<Scenario> read = Scenario.readFolder(scenarios, Bench.carla(), warnings::add);
    assertEquals(
        List.of("scenario-0", "scenario-1", "scenario-2", "scenario-3", "scenario-4"),
        read.stream().map(Scenario::name).toList());
    assertEquals(
        List.of("scenario.file.unread d.yaml~", "scenario.file.unread notes.txt"),
        warnings.stream().map(w -> w.id() + " " + fileName(w)).toList());
    assertEquals(7, Scenario.filesIn(scenarios).size());
  }

  @Test
  void theFileThatAScenarioPlaysIsFoundHoweverItsKeyIsWritten() throws IOException {
    for (String key : List.of("openscenario", "'openscenario'", "\"open\\x73cenario\"")) {
      Path scenario = folder.resolve("a.yaml");
      Files.writeString(scenario, "name: a\n" + key + ": {file: other.xosc}\n");
      assertEquals(List.of(scenario, folder.resolve("other.xosc")), Scenario.filesIn(folder), key);
    }
    Files.writeString(folder.resolve("a.yaml"), "name: a\n# open scenario: {file: other.xosc}\n");
    assertEquals(List.of(folder.resolve("a.yaml")), Scenario.filesIn(folder));
  }

  @Test
  void aFolderOfOtherFilesAndALinkThatLeadsNowhereAreErrors() throws IOException {
    Files.writeString(folder.resolve("a.yaml.bak"), "name: a");
    DiagnosticException none = assertThrows(DiagnosticException.class, () -> read(folder));
    assertEquals(
        List.of("scenario.none", "scenario.file.unread"),
        none.diagnostics().stream().map(Diagnostic::id).toList());
    Files.createSymbolicLink(folder.resolve("b.yaml"), folder.resolve("nowhere.yaml"));
    DiagnosticException lost = assertThrows(DiagnosticException.class, () -> read(folder));
    assertEquals("file.missing", lost.diagnostics().get(0).id());
    Files.createSymbolicLink(folder.resolve("circle"), folder);
    DiagnosticException endless = assertThrows(DiagnosticException.class, () -> read(folder));
    assertEquals("file.unreadable", endless.diagnostics().get(0).id());
  }

  private static void scenario(Path file, String name) throws IOException {
    Path original = AebProject.EXAMPLE.resolve("scenarios/empty-road.yaml");
    Files.createDirectories(file.getParent());
    Files.writeString(
        file, Files.readString(original).replaceFirst("(?m)^name: .*", "name: " + name));
  }

  private static String fileName(Diagnostic finding) {
    return Path.of(finding.location().file()).getFileName().toString();
  }

  private static List<Scenario> read(Path folder) {
    return Scenario.readFolder(folder, Bench.carla(), warning -> {});
  }
}
