package dev.eventchain.endtoend;

import static dev.eventchain.endtoend.WarningProject.COMPONENT;
import static dev.eventchain.endtoend.WarningProject.NAME;
import static dev.eventchain.endtoend.WarningProject.SIGN;
import static dev.eventchain.endtoend.WarningProject.TESTS;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests of {@code mutate} with mutants that end the process in which they run. */
class EndingMutantsTest {

  @TempDir Path folder;
  private WarningProject project;
  private ProjectCopy copy;

  @BeforeEach
  void copyTheExample() throws IOException {
    project = WarningProject.below(folder);
    copy = project.copy();
  }

  /** The host of the nodes is gone then, and others have to go on in a new one. */
  @InTurn
  @Test
  void aMutantThatEndsTheProcessOfTheNodesIsCaught() throws IOException {
    copy.delete(COMPONENT);
    copy.write(
        "software-base/nodes/warning.py",
        """
        import os
        from demo_msgs.msg import Threat
        from rclpy.node import Node
        from std_msgs.msg import Bool

        class Warning(Node):
            def __init__(self):
                super().__init__("warning")
                self.output = self.create_publisher(Bool, "/cluster/collision_warning", 10)
                self.create_subscription(Threat, "/aeb/threat", self.on_threat, 10)

            def on_threat(self, threat):
                if threat.time_to_collision < -1000000000000.0:
                    os._exit(3)
                self.output.publish(Bool(data=threat.time_to_collision < 2.6))
        """);
    project.hostTheNode();
    project.mutate().expect(1).says("[mutation.survived]");
    assertTrue(
        project.outcomes().containsAll(Set.of("ENDED", "UNNOTICED")), project.outcomes()::toString);
    assertFalse(project.outcomes().contains("UNPROVED"), project.outcomes()::toString);
    assertFalse(project.outcomes().contains("NOT_TRIED"), project.outcomes()::toString);
    for (JsonNode mutant : project.results()) {
      if (mutant.path("outcome").asText().equals("ENDED")) {
        assertTrue(
            mutant.path("words").asText().endsWith("with the exit code 3."), mutant::toString);
      }
    }
  }

  /** A scenario that the project itself does not survive tells nothing, and the others do. */
  @InTurn
  @Test
  void aProcessThatEndsWithoutADefectLeavesTheOthersToJudge() throws IOException {
    String scenario = Files.readString(copy.path().resolve("scenarios/stopped-vehicle-50.yaml"));
    copy.write(
        "scenarios/ending.yaml",
        scenario
            .replace("name: stopped-vehicle-50", "name: ending")
            .replace("gap_m: 80", "gap_m: 90"));
    copy.write(
        COMPONENT,
        """
        import os

        class Collision_Warning:
            def __init__(self):
                self.first = None

            def execute(self, ttc):
                self.first = self.first or (ttc if ttc < 900.0 else None)
                if "copy-" in __file__ and self.first and self.first > 6.2:
                    os._exit(3)
                return {"warns": ttc < 2.6}
        """);
    Program.Ended ended = project.mutate().expect(1);
    ended.says(
        "scenarios/ending.yaml:1:1: warning: Without a defect, a process ends, too, so that");
    ended.says("mutants: in the scenario ending, 3 of 3 times: ");
    ended.says("error: Nothing is known about this defect, since a process ended, and not each");
    assertTrue(project.outcomes().contains("CRITERION"), ended::out);
    assertTrue(project.outcomes().contains("UNPROVED"), project.outcomes()::toString);
    assertFalse(project.outcomes().contains("UNNOTICED"), project.outcomes()::toString);
  }

  @InTurn
  @Test
  void aMutantThatEndsItsOwnProcessIsCaughtByItsTest() throws Exception {
    copy.write(
        COMPONENT,
        """
        import os

        class Collision_Warning:
            def execute(self, ttc):
                if ttc < -1000000000000:
                    os._exit(3)
                return {"warns": ttc < 2.6}
        """);
    copy.write("tests/" + NAME + ".yaml", TESTS);
    project.mutate().says("by test");
    assertFalse(project.outcomes().contains("UNPROVED"), project.outcomes()::toString);
    for (JsonNode mutant : project.results()) {
      if (mutant.path("mutant").asText().equals(SIGN)) {
        assertEquals("TEST", mutant.path("outcome").asText());
        assertTrue(
            mutant.path("words").asText().contains("ended with the exit code 3"), mutant::toString);
      }
    }
  }
}
