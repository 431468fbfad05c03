package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The example that commands nothing: it passes as it is, and does not when anything is broken. */
class LaneDepartureTest {

  @TempDir private Path folder;
  private Path project;

  @BeforeEach
  void copyExample() throws IOException {
    project = folder.resolve("lane-departure");
    Program.copy(Program.ROOT.resolve("examples/lane-departure"), project);
  }

  private void replace(String file, String text, String by) throws IOException {
    Path path = project.resolve(file);
    String content = Files.readString(path);
    assertEquals(1, content.split(Pattern.quote(text), -1).length - 1, text);
    Files.writeString(path, content.replace(text, by));
  }

  private Program.Ended run() {
    return new Program().run("run", project);
  }

  @Test
  void everyRequirementIsProvedFromTheRecordings() {
    run().expect(0).says("PASSED: 15 of 15 scenarios passed, 7 requirements proved");
  }

  @Test
  void lampThatTheBenchDoesNotTakeEndsTheRun() throws IOException {
    replace("bench.yaml", "consumes:\n  /cluster/lane_departure:\n    observed: true\n", "");
    run()
        .expect(1)
        .says("INCOMPLETE: nothing was simulated")
        .says("writes /cluster/lane_departure to the vehicle, but the bench does not take it.")
        .says("[bench.topic.unconnected]");
  }

  @Test
  void speedThatNobodyProvidesEndsTheRun() throws IOException {
    replace(
        "bench.yaml",
        "  /vehicle/speed:\n    rate_hz: 50\n    fields:\n      data: ego.speed\n",
        "");
    run()
        .expect(1)
        .says("INCOMPLETE: nothing was simulated")
        .says("'Warning_Decision' reads /vehicle/speed, which no entry of the bench provides.");
  }

  @Test
  void latencyOfMoreThanAMillisecondFails() throws IOException {
    Files.writeString(
        project.resolve("constraints.ocl"),
        """
        context EventChain
          inv WarningWithinAMillisecond:
            self.measured->forAll(m | m.latency->notEmpty() implies m.latency.maximum <= 1.0)
        """);
    run()
        .expect(1)
        .says("FAILED")
        .says("constraints.ocl:2:")
        .says("EventChain::WarningWithinAMillisecond");
  }

  @Test
  void lampThatIsFrozenFails() throws IOException {
    replace(
        "software-base/components/Warning_Lamp.py",
        "\"left_lamp\": self._left > 0, \"right_lamp\": self._right > 0",
        "\"left_lamp\": False, \"right_lamp\": False");
    run().expect(1).says("FAILED").says("drift-left.yaml:").says("warned before the wheel is");
  }

  @Test
  void criterionThatIsAboutNothingIsNotTested() throws IOException {
    replace(
        "scenarios/too-slow.yaml",
        "not (/cluster/lane_departure.left or /cluster/lane_departure.right)",
        "(ego.speed > 200 km/h implies not /cluster/lane_departure.left)");
    run()
        .expect(1)
        .says("INCOMPLETE: 14 of 15 scenarios passed, but not all was tested")
        .says("too-slow.yaml:")
        .says("[simulation.criterion.untested]");
  }
}
