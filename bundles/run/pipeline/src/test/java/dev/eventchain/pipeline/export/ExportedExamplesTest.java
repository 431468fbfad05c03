package dev.eventchain.pipeline.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.Repository;
import dev.eventchain.pipeline.ProjectBench;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.export.ScenarioExport;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Body;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeMap;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the files of all examples put their actors where the simulation has them. */
class ExportedExamplesTest {

  /** What straight lines between the vertices of a trajectory leave open, in m and rad. */
  private static final double NEAR = 0.03;

  @ParameterizedTest
  @CsvSource({"aeb, 33", "acc, 19", "lane-departure, 15", "cut-in, 8", "radar-aeb, 2"})
  void actorsAreWhereTheyAreInTheSimulation(String example, int exported) {
    Project project = Project.open(Repository.ROOT.resolve("examples").resolve(example));
    List<Scenario> scenarios =
        Scenario.readFolder(project.scenarios(), ProjectBench.read(project), finding -> {});
    int compared = 0;
    for (Scenario scenario : scenarios) {
      ScenarioExport export = ScenarioExport.of(scenario, example);
      if (!export.files().isEmpty()) {
        compare(scenario, export);
        compared++;
      }
    }
    assertEquals(exported, compared);
  }

  /** A bend with a lane change in it, and actors with names that mean something in the files. */
  @ParameterizedTest
  @ValueSource(strings = {"bend", "names"})
  void soAreTheyInOtherScenarios(String name) {
    Path folder = Repository.ROOT.resolve("bundles/robot/simulation/src/test/resources/export");
    Scenario scenario = Scenario.read(folder.resolve(name + ".yaml"), Bench.carla());
    compare(scenario, ScenarioExport.of(scenario, "software"));
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
        String where = scenario.name() + ", " + actor.name() + " after " + i / 100.0 + " s";
        assertEquals(body.place().x(), played.x(), NEAR, where);
        assertEquals(body.place().y(), played.y(), NEAR, where);
        double turned = Math.IEEEremainder(body.place().heading() - played.heading(), 2 * Math.PI);
        assertEquals(0.0, turned, NEAR, where);
      }
    }
  }

  private static String text(ScenarioExport export, String name) {
    return new String(new TreeMap<>(export.files()).get(name), StandardCharsets.UTF_8);
  }
}
