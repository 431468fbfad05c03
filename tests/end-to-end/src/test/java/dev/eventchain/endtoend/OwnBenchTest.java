package dev.eventchain.endtoend;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that the verdict names broken connections between the bench of a custom function and its
 * components.
 */
class OwnBenchTest {

  @TempDir private Path folder;
  private ProjectCopy project;

  @BeforeEach
  void copyProject() throws IOException {
    project = ProjectCopy.of("radar-aeb", folder);
  }

  @Test
  void brakeThatIsDisconnectedInTheBench() throws IOException {
    project.replace("bench.yaml", "{drives: acceleration, required: true}", "observed");
    project
        .run()
        .expect(1)
        .says("'no impact' was not tested: no component's output drives the brake.")
        .says("[simulation.criterion.untested]");
    project.requireNotPassed();
  }

  @Test
  void requiredFieldThatNoComponentWrites() throws IOException {
    project.replace(
        "bench.yaml",
        "acceleration: {drives: acceleration, required: true}",
        "hold: {drives: acceleration, unit: m/s2, required: true}");
    project
        .run()
        .expect(1)
        .says("INCOMPLETE")
        .says("bench.yaml:15:7")
        .says("No component writes 'hold' of /brake/request, which the bench requires.")
        .says("[bench.field.unwritten]");
    project.requireNotPassed();
  }

  @Test
  void providedTopicWithoutSource() throws IOException {
    Files.delete(project.path().resolve("scenarios/short-sight.yaml"));
    String bench = Files.readString(project.path().resolve("bench.yaml"));
    Files.writeString(
        project.path().resolve("bench.yaml"),
        bench.replaceAll("(?s)provides:.*consumes", "consumes"));
    project
        .run()
        .expect(1)
        .says("INCOMPLETE")
        .says("'Radar_Tracking' reads /radar/target, which no entry of the bench provides.")
        .says("model/chain.xmi:")
        .says("[bench.topic.unconnected]");
    project.requireNotPassed();
  }

  @Test
  void fieldThatTheBenchLeavesAtItsDefault() throws IOException {
    project.replace("bench.yaml", "      range_rate: lead.speed - ego.speed\n", "");
    project
        .run()
        .expect(1)
        .says("INCOMPLETE")
        .says("'range_rate' of /radar/target is read, but the bench leaves it at its default.")
        .says("[bench.field.unset]");
    project.requireNotPassed();
  }

  @Test
  void fieldThatDrivesButThatNoComponentWrites() throws IOException {
    project.replace(
        "bench.yaml",
        "acceleration: {drives: acceleration, required: true}",
        "hold: {drives: acceleration, unit: m/s2}");
    project.run().expect(1).says("was not tested: no component's output drives the brake.");
    project.requireNotPassed();
  }

  @Test
  void unitOfTheComponentIsComparedWithThatOfTheBench() throws IOException {
    project.replace("software-base/signals.json", ", \"Unit\": \"km/h\"", "");
    project.replace(
        "bench.yaml", "lead.speed - ego.speed", "{value: lead.speed - ego.speed, unit: m/s}");
    project
        .run()
        .expect(1)
        .says("'range_rate' of /radar/target is in km/h here, but in another unit in the bench.")
        .says("[bench.unit]");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void inputThatIsComputedFromTheWorldCanBeJudged() throws IOException {
    project.replace("bench.yaml", "inputs:", "inputs:\n  reserve: {unit: m, formula: gap - 1 m}");
    project.replace(
        "scenarios/short-sight.yaml",
        "  formulas:",
        "  formulas:\n    - formula: always reserve > 0 m");
    project.run().expect(0).says("PASSED: 2 of 2 scenarios passed, 4 requirements proved");
  }

  @Test
  void scenarioThatSetsAnInputThatTheBenchDoesNotHave() throws IOException {
    project.replace("scenarios/short-sight.yaml", "radar.reach: 60", "radar.reech: 60");
    project
        .run()
        .expect(2)
        .says("The bench has no input 'radar.reech'.")
        .says("Did you mean `radar.reach`?")
        .says("[scenario.input.unknown]");
    project.requireNotPassed();
  }

  @Test
  void inputOnWhichNothingDepends() throws IOException {
    project.replace("bench.yaml", "gap < radar.reach", "gap < 150 m");
    project.replace("bench.yaml", "min(gap, radar.reach)", "min(gap, 150 m)");
    project
        .run()
        .expect(2)
        .says("Nothing that is sent or judged depends on the input 'radar.reach'.")
        .says("short-sight.yaml:11:3");
    project.requireNotPassed();
  }

  @Test
  void wrongBenchIsFoundBeforeAnythingRuns() throws IOException {
    project.replace("bench.yaml", "rate_hz: 50", "rate_hz: 1000000");
    project.run().expect(2).says("bench.yaml:6:14").says("[bench.value.range]");
    project.requireNotPassed();
  }
}
