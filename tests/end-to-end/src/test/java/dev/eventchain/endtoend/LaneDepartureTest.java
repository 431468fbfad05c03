package dev.eventchain.endtoend;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the example without actuation: it passes unchanged, and fails with any defect. */
class LaneDepartureTest {

  @TempDir private Path folder;
  private ProjectCopy project;

  @BeforeEach
  void copyExample() throws IOException {
    project = ProjectCopy.of("lane-departure", folder);
  }

  @InTurn
  @Test
  void everyRequirementIsProvedFromTheRecordings() throws IOException {
    project
        .run()
        .expect(0)
        .says("PASSED: 16 of 16 scenarios passed, 7 requirements proved")
        .saysNothingOf("No scenario shows");
    Program.requireBoundsHold(project.path());
  }

  @Test
  void lampThatTheBenchDoesNotTakeEndsTheRun() throws IOException {
    project.replace(
        "bench.yaml", "consumes:\n  /cluster/lane_departure:\n    observed: true\n", "");
    project
        .run()
        .expect(1)
        .says("INCOMPLETE: nothing was simulated")
        .says("writes /cluster/lane_departure to the vehicle, but the bench does not take it.")
        .says("[bench.topic.unconnected]");
  }

  @Test
  void speedThatNobodyProvidesEndsTheRun() throws IOException {
    project.replace(
        "bench.yaml",
        "  /vehicle/speed:\n    rate_hz: 50\n    fields:\n      data: ego.speed\n",
        "");
    project
        .run()
        .expect(1)
        .says("INCOMPLETE: nothing was simulated")
        .says("'Warning_Decision' reads /vehicle/speed, which no entry of the bench provides.");
  }

  @InTurn
  @Test
  void latencyOfMoreThanAMillisecondFails() throws IOException {
    Files.writeString(
        project.path().resolve("constraints.ocl"),
        """
        context EventChain
          inv WarningWithinAMillisecond:
            self.measured->forAll(m | m.latency->notEmpty() implies m.latency.maximum <= 1.0)
        """);
    project
        .run()
        .expect(1)
        .says("FAILED")
        .says("constraints.ocl:2:")
        .says("EventChain::WarningWithinAMillisecond");
  }

  @InTurn
  @Test
  void lampThatIsFrozenFails() throws IOException {
    project.replace(
        "software-base/components/Warning_Lamp.py",
        "\"left_lamp\": self._left > 0, \"right_lamp\": self._right > 0",
        "\"left_lamp\": False, \"right_lamp\": False");
    project
        .run()
        .expect(1)
        .says("FAILED")
        .says("drift-left.yaml:")
        .says("warned before the wheel is");
  }

  @InTurn
  @Test
  void criterionThatIsAboutNothingIsNotTested() throws IOException {
    project.replace(
        "scenarios/too-slow.yaml",
        "not (/cluster/lane_departure.left or /cluster/lane_departure.right)",
        "(ego.speed > 120 km/h implies not /cluster/lane_departure.left)");
    project
        .run()
        .expect(1)
        .says("INCOMPLETE: 15 of 16 scenarios passed, but not all was tested")
        .says("too-slow.yaml:")
        .says("[simulation.criterion.untested]");
  }
}
