package dev.eventchain.pipeline.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.pipeline.ProjectBench;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.export.ScenarioExport;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the files of all examples put their actors where the simulation has them. */
class ExportedExamplesTest {

  /** Tolerance for straight lines between the vertices of a trajectory, in m and rad. */
  private static final double NEAR = 0.03;

  /** Distance between the ways of two controllers that steer the ego, in m. */
  private static final double STEERED = 0.6;

  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource({"aeb, 33", "acc, 21", "lane-departure, 16", "cut-in, 9", "radar-aeb, 2"})
  void actorsAreWhereTheyAreInTheSimulation(String example, int exported) {
    Project project = Project.open(Repository.ROOT.resolve("examples").resolve(example));
    List<Scenario> scenarios =
        Scenario.readFolder(project.scenarios(), ProjectBench.read(project), finding -> {});
    int compared = 0;
    for (Scenario scenario : scenarios) {
      ScenarioExport export = ScenarioExport.of(scenario, example);
      if (!export.files().isEmpty()) {
        compare(scenario, export);
        readBack(scenario, export);
        compared++;
      }
    }
    assertEquals(exported, compared);
  }

  /** A bend with a lane change in it, and actors with names that mean something in the files. */
  @ParameterizedTest
  @ValueSource(strings = {"bend", "names"})
  void soAreTheyInOtherScenarios(String name) {
    Path exported = Repository.ROOT.resolve("bundles/robot/simulation/src/test/resources/export");
    Scenario scenario = Scenario.read(exported.resolve(name + ".yaml"), Bench.carla());
    compare(scenario, ScenarioExport.of(scenario, "software"));
    readBack(scenario, ScenarioExport.of(scenario, "software"));
  }

  /** Scripts of vehicles that never stand, whose changes of speed and lane overlap in all ways. */
  @Test
  void soAreTheyWithAnyScript() {
    Random random = new Random(36);
    int compared = 0;
    for (int i = 0; i < 150; i++) {
      String text = anyScenario(i, random);
      Scenario scenario;
      try {
        scenario = Scenario.parse(SourceText.of("any.yaml", text), Bench.carla());
      } catch (DiagnosticException e) {
        continue; // It moves to the side while it stands, or before the last one has ended.
      }
      ScenarioExport export = ScenarioExport.of(scenario, "software");
      assertEquals(List.of(), export.diagnostics(), text);
      compare(scenario, export);
      compared++;
    }
    assertTrue(compared > 50, "compared " + compared);
  }

  private static String anyScenario(int number, Random random) {
    StringBuilder text = new StringBuilder("name: any\ntitle: Any ").append(number);
    text.append("\nduration_s: 12\naccept: {no_impact: true}\n");
    text.append("ego: {speed_kmh: 50}\n");
    if (random.nextBoolean()) {
      int radius = (random.nextBoolean() ? 1 : -1) * (100 + random.nextInt(400));
      text.append("road: {curve_radius_m: ").append(radius).append("}\n");
    }
    text.append("actors:\n");
    for (int i = 0; i < 2; i++) {
      text.append("  - {gap_m: ").append(40 + 60 * i);
      text.append(", speed_kmh: ").append(5 + random.nextInt(95));
      text.append(", lateral_offset_m: ").append(random.nextInt(9) - 4);
      int angle = List.of(0, 0, 0, 180, 90, -30).get(random.nextInt(6));
      text.append(", heading_deg: ").append(angle);
      text.append(random.nextInt(4) == 0 ? ", keeps_heading: true" : "");
      text.append(", maneuvers: [").append(anyManeuvers(random)).append("]}\n");
    }
    return text.toString();
  }

  private static String anyManeuvers(Random random) {
    List<String> maneuvers = new ArrayList<>();
    double speedAt = 0;
    double sideAt = 0;
    for (int i = random.nextInt(4); i > 0; i--) {
      if (random.nextBoolean()) {
        speedAt += random.nextInt(400) / 100.0;
        maneuvers.add(
            "{at_s: %s, speed_kmh: %s, acceleration_mps2: %s}"
                .formatted(speedAt, 5 + random.nextInt(105), 1 + random.nextInt(5)));
      } else {
        sideAt += random.nextInt(600) / 100.0;
        String shape =
            random.nextInt(3) == 0 ? ", shape: linear, lateral_acceleration_mps2: 2" : "";
        maneuvers.add(
            "{at_s: %s, lateral_offset_m: %s, lateral_speed_mps: %s%s}"
                .formatted(sideAt, random.nextInt(9) - 4, 0.5 + random.nextInt(3) / 2.0, shape));
      }
    }
    return String.join(", ", maneuvers);
  }

  private static void compare(Scenario scenario, ScenarioExport export) {
    FilePlayer player =
        new FilePlayer(
            text(export, scenario.name() + ".xosc"), text(export, scenario.name() + ".xodr"));
    List<String> entities = player.entities();
    assertEquals("Ego", entities.get(0));
    int next = 1;
    for (Actor actor : scenario.situation().actors()) {
      String entity = entities.get(next++);
      double middle = player.middle(entity);
      List<FilePlayer.Pose> poses = player.poses(entity, scenario.duration());
      assertTrue(poses.size() > 10);
      for (int i = 0; i < poses.size(); i++) {
        Body body = actor.body(scenario.situation().road(), i / 100.0);
        FilePlayer.Pose played = poses.get(i).ahead(middle);
        String where = scenario.title() + ", " + actor.name() + " after " + i / 100.0 + " s";
        assertEquals(body.place().x(), played.x(), NEAR, where);
        assertEquals(body.place().y(), played.y(), NEAR, where);
        double turned = Math.IEEEremainder(body.place().heading() - played.heading(), 2 * Math.PI);
        assertEquals(0.0, turned, NEAR, where);
      }
    }
  }

  /** Reads the files and lets both worlds run side by side, without software. */
  private void readBack(Scenario scenario, ScenarioExport export) {
    for (Map.Entry<String, byte[]> file : export.files().entrySet()) {
      written(file.getKey(), file.getValue());
    }
    String text =
        """
        name: back
        title: Read back
        duration_s: %s
        openscenario: {file: %s.xosc}
        accept: {no_impact: true}
        """
            .formatted(scenario.duration(), scenario.name());
    Path file = folder.resolve("back.yaml");
    Scenario back = Scenario.parse(SourceText.of(file.toString(), text), Bench.carla());
    World one = world(scenario);
    World other = world(back);
    long end = World.nanoseconds(scenario.duration());
    while (one.now() < end && !one.isOver() && !other.isOver()) {
      requireNear(scenario, one, other);
      one.advanceTo(one.now() + World.TRACE_STEP);
      other.advanceTo(other.now() + World.TRACE_STEP);
    }
    assertTrue(Math.abs(one.now() - other.now()) <= World.TRACE_STEP, scenario.title());
  }

  private static void requireNear(Scenario scenario, World one, World other) {
    double seconds = World.seconds(one.now());
    String where = scenario.title() + " after " + seconds + " s: ";
    requireNear(where + "ego", one.ego().front(), other.ego().front(), STEERED);
    assertEquals(one.allActors().size(), other.allActors().size());
    for (int i = 0; i < one.allActors().size(); i++) {
      Actor actor = one.allActors().get(i);
      requireNear(
          where + actor.name(),
          actor.body(one.road(), seconds).place(),
          other.allActors().get(i).body(other.road(), seconds).place(),
          NEAR);
    }
  }

  private static void requireNear(
      String where, Road.Place one, Road.Place other, double tolerance) {
    assertEquals(0.0, Math.hypot(one.x() - other.x(), one.y() - other.y()), tolerance, where);
  }

  private static World world(Scenario scenario) {
    Situation situation = scenario.situation();
    return new World(situation, new Trace(scenario.inputs(), situation.road()));
  }

  private void written(String name, byte[] content) {
    try {
      Files.write(folder.resolve(name), content);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String text(ScenarioExport export, String name) {
    return new String(new TreeMap<>(export.files()).get(name), StandardCharsets.UTF_8);
  }
}
