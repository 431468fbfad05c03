package dev.eventchain.endtoend;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that a latency constraint is not proved by the times of messages whose values are old, nor
 * by components that take no time. The project that it was made from passes in {@link
 * EvidenceTest}.
 */
class LatencyEvidenceTest {

  private static final String ARBITER = "software-base/components/Brake_Arbiter.py";

  @TempDir private Path folder;

  private ProjectCopy pedestrianBrake() throws IOException {
    Projects.copy(
        Program.ROOT.resolve("tests/end-to-end/src/test/resources/pedestrian-brake"), folder);
    return new ProjectCopy(Projects.withoutStrength(folder));
  }

  @InTurn
  @Test
  void delayOfInputsWithinAComponentCountsForTheLatency() throws IOException {
    ProjectCopy project = pedestrianBrake();
    project.replace(ARBITER, "BRAKE_BELOW = 1.4", "BRAKE_BELOW = 1.7");
    project.replace(
        ARBITER,
        "        self._holds = False\n\n",
        "        self._holds = False\n        self._late = []\n\n");
    project.replace(
        ARBITER,
        "        if accelerator > KICK_DOWN or not available:",
        """
                self._late.append((available, present, ttc))
                late = len(self._late) > 15
                available, present, ttc = self._late.pop(0) if late else (True, False, 100.0)
                if accelerator > KICK_DOWN or not available:\
        """);
    project
        .run()
        .expect(1)
        .says("warning: The value latency of 'Brake_Arbiter' is 300 ms from '")
        .says("[simulation.value.late]")
        .says("error: 'list_to_brake' allows 150.0 ms from Crossing_Prediction to Brake_Arbiter")
        .says("10 requirements proved, 1 violated");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void latencyOfASensorCountsWhereItIsAskedFor() throws IOException {
    ProjectCopy project = pedestrianBrake();
    project.replace(
        "bench.yaml",
        "latency_ms: 40\n",
        "latency_ms: 40\n    latency_counts_in: [list_to_brake]\n");
    project.replace("model/chain.xmi", "maximum=\"150\"", "maximum=\"100\"");
    project
        .run()
        .expect(1)
        .says("error: 'list_to_brake' allows 100.0 ms from Crossing_Prediction to Brake_Arbiter")
        .says("but 111.7");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void constraintWithoutAnExecutionTimeOnItsPathIsNotTested() throws IOException {
    ProjectCopy project = pedestrianBrake();
    project.replace("model/chain.xmi", " worstCaseExecutionTime=\"10.0\"", "");
    project.replace("software-base/components.json", ", \"worst_case_execution_time\": 10,", ",");
    project
        .run()
        .expect(1)
        .says("chain.xmi:3:3: error: 'Crossing_Prediction' has no worst-case execution time")
        .says("[simulation.latency.lower-bound]")
        .says("INCOMPLETE")
        .says("10 requirements proved, 1 not tested");
    project.requireNotPassed();
  }
}
