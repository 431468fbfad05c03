package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the search for failing cases with the small radar example. */
class SearchTest {

  private static final Path CAMPAIGN =
      Program.ROOT.resolve(
          "tests/end-to-end/src/test/resources/search/radar-aeb-stopped-vehicle-50.yaml");
  private static final String BRAKE = "software-base/components/Brake_Request.py";

  @TempDir Path folder;
  private ProjectCopy copy;

  @BeforeEach
  void copyTheExample() throws IOException {
    copy = ProjectCopy.of("radar-aeb", folder);
    copy.endAtEightSeconds();
    settings("runs: 16, seeds: 2");
  }

  private void settings(String search) throws IOException {
    copy.write("approach.yaml", Files.readString(CAMPAIGN) + "search: {" + search + "}\n");
  }

  private Program.Ended search(Program program, String... more) {
    Object[] arguments = new Object[more.length + 3];
    arguments[0] = "search";
    arguments[1] = copy.path();
    arguments[2] = copy.path().resolve("approach.yaml");
    System.arraycopy(more, 0, arguments, 3, more.length);
    return program.run(arguments);
  }

  private Path results(String name) {
    return copy.path().resolve("out/searches/approach/" + name);
  }

  private List<byte[]> bytes() throws IOException {
    return List.of(
        Files.readAllBytes(results("cases.csv")), Files.readAllBytes(results("cases.json")));
  }

  @InTurn
  @Test
  void nothingIsFoundInTheExampleAndTheSameOnAnyNumberOfProcessors() throws IOException {
    search(new Program())
        .expect(0)
        .says("16 cases: 16 passed, 0 failed")
        .says("smallest margin of 'no impact': ")
        .says("Searched by cma_es with 2 seeds: speed from 45 to 60, gap from 60 to 90, ")
        .says("That nothing was found in 16 runs does not prove that there is nothing.");
    List<String> rows = Files.readAllLines(results("cases.csv"));
    assertEquals(17, rows.size());
    assertTrue(rows.get(0).startsWith("case,search_seed,search_run,speed,gap,offset,brake,"));
    List<byte[]> expected = bytes();
    search(new Program()).expect(0).says("= Simulate");
    assertSame(expected);
    Files.delete(results("cases.json"));
    search(new Program().with("JAVA_TOOL_OPTIONS", "-XX:ActiveProcessorCount=1"))
        .expect(0)
        .says("✓ Simulate");
    assertSame(expected);
  }

  @InTurn
  @Test
  void anInterruptLosesNothingAndLeavesNoProcess() throws Exception {
    search(new Program()).expect(0);
    List<byte[]> expected = bytes();
    Path err = folder.resolve("err.txt");
    for (int attempt = 1; !interruptedOnce(err); attempt++) {
      assertTrue(attempt < 10, "the program always ends before it is interrupted");
    }
    assertTrue(Files.readString(err).contains("interrupted"), Files.readString(err));
    search(new Program()).expect(0);
    assertSame(expected);
  }

  /** Interrupts the program after it has kept a run; returns false if it had ended already. */
  private boolean interruptedOnce(Path err) throws Exception {
    copy.delete("out/searches");
    // A shell that starts tests in the background makes its children ignore interrupts.
    Process search =
        new Program()
            .by("env", "--default-signal=INT")
            .start(
                folder.resolve("out.txt"),
                err,
                "search",
                copy.path(),
                copy.path().resolve("approach.yaml"));
    while (search.isAlive() && !Files.exists(results("parts/000001.json"))) {
      Thread.sleep(5);
    }
    return Program.interrupt(search) == 130;
  }

  private void assertSame(List<byte[]> expected) throws IOException {
    List<byte[]> found = bytes();
    for (int i = 0; i < expected.size(); i++) {
      assertArrayEquals(expected.get(i), found.get(i));
    }
  }

  /** Lets the function brake too late for the fastest approaches only. */
  private void plantADefect() throws IOException {
    settings("runs: 60, seeds: 2, criterion: no impact, stop: first_failure");
    copy.replace(BRAKE, "FULL_BRAKE_TTC = 1.6", "FULL_BRAKE_TTC = 1.3");
  }

  @InTurn
  @Test
  void nothingIsKeptBehindALink() throws IOException {
    plantADefect();
    Path link = copy.path().resolve("scenarios/found");
    Files.createSymbolicLink(link, Files.createDirectory(folder.resolve("elsewhere")));
    search(new Program(), "--keep").expect(2).says("'found' is a link");
  }

  @Test
  void aDefectIsFoundAndKeptAsAScenarioThatFails() throws IOException {
    plantADefect();
    Path junit = folder.resolve("junit.xml");
    search(new Program(), "--keep", "--report", "junit=" + junit)
        .expect(1)
        .says("[search.found]")
        .says("It stopped at the first failure.");
    assertTrue(Files.readString(junit).contains("failures=\"1\""));
    Path kept = copy.path().resolve("scenarios/found/stopped-vehicle-50-found-1.yaml");
    String text = Files.readString(kept);
    assertTrue(text.contains("name: stopped-vehicle-50-found-1\n"), text);
    assertEquals(text, Files.readString(results("found/stopped-vehicle-50-found-1.yaml")));
    search(new Program(), "--keep").expect(1).says("Kept: " + kept);
    Files.writeString(kept, text.replace("duration_s: 8", "duration_s: 9"));
    search(new Program(), "--keep").expect(1).says("-found-2.yaml");
    copy.onlyScenario("scenarios/found");
    new Program()
        .run("run", copy.path())
        .expect(1)
        .says("FAILED")
        .says("stopped-vehicle-50-found-1")
        .says("stopped-vehicle-50-found-2");
  }

  @Test
  void aCriterionThatIsNoneIsFoundBeforeAnythingIsSimulated() throws IOException {
    settings("criterion: no impacts");
    search(new Program())
        .expect(2)
        .says("approach.yaml:8:21")
        .says("No criterion of 'stopped-vehicle-50' begins with 'no impacts'.")
        .says("[search.criterion]");
    settings("criterion: the");
    search(new Program()).expect(2).says("Several criteria");
    assertFalse(Files.exists(results("cases.csv")));
  }

  @Test
  void fewRunsAreSaid() throws IOException {
    copy.write(
        "approach.yaml",
        """
        scenario: stopped-vehicle-50
        factors:
          speed: {path: ego.speed_kmh, values: [45, 50]}
        search: {runs: 10}
        """);
    search(new Program())
        .expect(0)
        .says("Only 2 of 10 runs were simulated")
        .says("[search.few-runs]");
  }

  /** Standing at the end has no margin while it does. */
  @InTurn
  @Test
  void aCriterionWithoutAMarginLeadsNowhere() throws IOException {
    settings("runs: 10, criterion: the vehicle stops");
    search(new Program()).expect(0).says("[search.nothing-to-minimise]").says("Searched at random");
  }

  @InTurn
  @Test
  void numbersOfTheBenchAreNotKept() throws IOException {
    copy.write(
        "approach.yaml",
        """
        scenario: stopped-vehicle-50
        factors:
          reach: {path: "bench:inputs.radar.reach.value", uniform: [8, 12]}
        search: {runs: 10, stop: first_failure}
        """);
    search(new Program(), "--keep").expect(1).says("Not kept: ").says("[search.found]");
    assertTrue(Files.exists(results("found/stopped-vehicle-50-found-1.bench.txt")));
    assertFalse(Files.exists(copy.path().resolve("scenarios/found")));
  }
}
