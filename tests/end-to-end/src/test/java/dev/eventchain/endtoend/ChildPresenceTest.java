package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the example whose signals are those of a whole vehicle. */
class ChildPresenceTest {

  /** Longest prompt of a design, in bytes. */
  private static final int LONGEST = 20_000;

  private static final String SEATS =
      "Vehicle.Cabin.Seat.{Row1,Row2}.{DriverSide,Middle,PassengerSide}.OccupancyStatus";

  @TempDir private Path folder;
  private ProjectCopy project;

  @BeforeEach
  void copyExample() throws IOException {
    project = ProjectCopy.of("child-presence", folder);
  }

  @InTurn
  @Test
  void everyRequirementIsProvedFromTheRecordings() throws IOException {
    project.run().expect(0).says("PASSED: 15 of 15 scenarios passed, 7 requirements proved");
    String report = Files.readString(project.path().resolve("out/report.html"));
    assertTrue(report.contains("\"signals\":\"" + SEATS + "\",\"number\":6"));
  }

  @Test
  void designIsOfferedWhatItsRequirementsSpeakOf() throws IOException {
    new Program()
        .run("run", project.path(), "--to", "design")
        .expect(0)
        .says("event chain from 7 requirements, offered 97 of 1367 signals");
    String offered = Files.readString(project.path().resolve("out/retrieved.json"));
    assertTrue(offered.contains(SEATS), offered);
    assertFalse(offered.contains("Infotainment"), offered);
  }

  /** The prompt is written in the place of the answer that no recording has. */
  @Test
  void promptStaysShortWithTheWholeCatalogue() throws IOException {
    project.replace("eventchain.yaml", "shortlist: 32", "shortlist: 31");
    Path prompts = folder.resolve("prompts");
    new Program()
        .run("run", project.path(), "--llm", "handoff:" + prompts, "--to", "design")
        .expect(4);
    String prompt = Files.readString(prompts.resolve("design-01.prompt.md"));
    int length = prompt.getBytes(StandardCharsets.UTF_8).length;
    assertTrue(length < LONGEST, length + " bytes");
    assertEquals(31, prompt.lines().filter(line -> line.startsWith("- /vss/")).count());
    assertTrue(prompt.contains("/vss_target/Vehicle/Body/Horn/IsActive (std_msgs/msg/Bool"));
  }

  @Test
  void requirementsWithoutAWordOfTheCatalogueAreReported() throws IOException {
    project.write("requirements.md", "- CP-1: Wer vergessen wurde, wird gemeldet.\n");
    new Program()
        .run(
            "run",
            project.path(),
            "--llm",
            "handoff:" + folder.resolve("prompts"),
            "--to",
            "design")
        .expect(4)
        .says("[catalogue.nothing-retrieved]");
  }

  @Test
  void benchListsNoSignalThatTheChainDoesNotUse() {
    new Program()
        .run("bench", project.path())
        .expect(0)
        .says("seat.middle: EMPTY, OCCUPIED, UNKNOWN")
        .says("not connected: 1333 topics that the vehicle provides and the chain does not use")
        .says("not connected: 640 topics that the vehicle takes and the chain does not use");
  }

  @InTurn
  @Test
  void textThatNoNumberStandsForEndsTheRun() throws IOException {
    project.onlyScenario("scenarios/empty.yaml");
    project.replace("scenarios/empty.yaml", "seat.middle: 2", "seat.middle: 3");
    project.run().says("'seat.middle' is none of the 3 texts.").says("[bench.value.range]");
  }
}
