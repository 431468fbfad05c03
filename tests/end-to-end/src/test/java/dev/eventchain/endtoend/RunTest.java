package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests a run from requirements to a verdict, as in the README. One build in ten measures the
 * strength of its requirements, which takes longer than the rest; {@link StrengthTest} and the
 * tutorial of {@link DocumentationTest} do so in each.
 */
class RunTest {

  private static final boolean WITH_STRENGTH = InTurn.Condition.isDayOf("RunTest.strength");

  @TempDir static Path folder;

  private static Path project;
  private static Program.Ended first;

  @BeforeAll
  static void runOnce() throws IOException {
    project = Program.wholeExampleIn(folder);
    Projects.copy(Program.ROOT.resolve("examples/aeb/tests"), project.resolve("tests"));
    if (WITH_STRENGTH) {
      Projects.measureStrength(project);
    }
    first = new Program().run("run", project);
  }

  @Test
  void theExamplePassesAndSaysSo() {
    first
        .expect(0)
        .says("PASSED: 33 of 33 scenarios passed, 6 requirements proved")
        .says("report.html");
  }

  @Test
  void noLatencyIsAboveItsBound() throws IOException {
    Program.requireBoundsHold(project);
  }

  /** Except for times, and the confinement of components on this machine. */
  @Test
  void theReadmeShowsWhatIsPrinted() throws IOException {
    List<String> printed =
        (first.err() + first.out())
            .replace(project.toString(), "examples/aeb")
            .lines()
            .map(RunTest::withoutThisMachine)
            .toList();
    List<String> shown =
        readme("(?s).*\n```console\n\\$ \\./eventchain run examples/aeb\n(.*?)```\n.*")
            .lines()
            .map(RunTest::ofThisRun)
            .map(RunTest::withoutThisMachine)
            .filter(line -> !line.equals("..."))
            .toList();

    assertEquals(9, shown.size(), "each stage, and the verdict: " + shown);
    assertEquals(shown, printed.stream().filter(shown::contains).toList());
  }

  private static String withoutThisMachine(String line) {
    return line.replaceAll(" +[0-9.]+ s ", " T s ").replaceAll("[0-9]+ times real time,.*", "");
  }

  /** Returns a line of the README as this run prints it. */
  private static String ofThisRun(String line) {
    return WITH_STRENGTH
        ? line
        : line.replaceFirst(
            "[0-9]+ runs with standard faults in [0-9]+ simulated s", "strength not measured");
  }

  @Test
  void theReadmeShowsAFindingAsItIsPrinted() throws IOException {
    Path model = folder.resolve("finding/chain.xmi");
    Files.createDirectories(model.getParent());
    String chain = Files.readString(project.resolve("out/chain.xmi"));
    String name = "<software name=\"";
    Files.writeString(model, chain.replace(name + "Braking_Decision", name + "class"));
    Path messages = project.resolve("software-base/msg");

    Program.Ended ended = new Program().run("validate", model, "--messages", messages).expect(1);

    String shown = readme("(?s).*```\n(aeb/model/chain\\.xmi:.*?)```\n.*");
    ended.says(shown.replace("aeb/model/chain.xmi", model.toString()));
  }

  /** Returns the part of the README that matches the only group of a pattern. */
  private static String readme(String pattern) throws IOException {
    String text = Files.readString(Program.ROOT.resolve("README.md"));
    Matcher matcher = Pattern.compile(pattern).matcher(text);
    assertTrue(matcher.matches(), pattern);
    return matcher.group(1);
  }

  @Test
  void everyFileOfTheUsersFolderIsThere() {
    for (String name :
        List.of(
            "chain.json",
            "chain.xmi",
            "generated.ocl",
            "components/TTC_Calculation.py",
            "components/Braking_Decision.py",
            "ros2/aeb/aeb/ttc_calculation_node.py",
            "ros2/aeb/aeb/components/ObjectDetection.py",
            "report.html",
            "measurements.json",
            "measurements.csv",
            "curves/stopped-vehicle-50.csv",
            "verdict.json",
            "chain.measured.xmi",
            "COLCON_IGNORE")) {
      assertTrue(Files.exists(project.resolve("out").resolve(name)), name);
    }
  }

  @Test
  void curvesAreTablesWithAColumnForEachQuantity() throws IOException {
    List<String> lines = Files.readAllLines(project.resolve("out/curves/stopped-vehicle-50.csv"));
    List<String> headings = List.of(lines.get(0).split(",", -1));
    assertEquals("time [s]", headings.get(0));
    int speed = headings.indexOf("ego.speed [m/s]");
    assertEquals("13.8889", lines.get(1).split(",", -1)[speed]);
    assertTrue(lines.stream().allMatch(line -> line.split(",", -1).length == headings.size()));
  }

  @InTurn
  @Test
  void aFreshRunElsewhereGivesTheSameBytes() throws IOException {
    Path other = folder.resolve("elsewhere");
    new Program().run("run", project, "-o", other, "--no-strength").expect(0);
    assertEquals(withoutStrength(project.resolve("out")), withoutStrength(other));
    for (String name :
        List.of(
            "chain.json",
            "chain.xmi",
            "generated.ocl",
            "measurements.csv",
            "curves/stopped-vehicle-50.csv",
            "chain.measured.xmi")) {
      assertArrayEquals(
          Files.readAllBytes(project.resolve("out").resolve(name)),
          Files.readAllBytes(other.resolve(name)),
          name);
    }
    assertEquals(withoutDelayed(project.resolve("out")), withoutDelayed(other));
    JsonNode one = measurements(project.resolve("out"));
    JsonNode two = measurements(other);
    assertEquals(one, two);
  }

  /** Returns a verdict without its strength, which {@link StrengthTest} compares. */
  private static JsonNode withoutStrength(Path out) throws IOException {
    JsonNode verdict = new ObjectMapper().readTree(out.resolve("verdict.json").toFile());
    List<JsonNode> with = verdict.findParents("strength");
    assertFalse(with.isEmpty(), verdict::toString);
    with.forEach(each -> ((ObjectNode) each).remove("strength"));
    return verdict;
  }

  /** Scenarios are driven again with the latency at its bound where strength is measured. */
  private static JsonNode withoutDelayed(Path out) throws IOException {
    JsonNode latencies = new ObjectMapper().readTree(out.resolve("latency-bounds.json").toFile());
    assertFalse(latencies.isEmpty());
    latencies.forEach(each -> ((ObjectNode) each).remove("delayed"));
    return latencies;
  }

  /** Host times are separate because they differ. */
  private static JsonNode measurements(Path out) throws IOException {
    JsonNode json = new ObjectMapper().readTree(out.resolve("measurements.json").toFile());
    assertTrue(json.has("host"), "host times stand apart");
    return ((ObjectNode) json).without("host");
  }

  @Test
  void aSecondRunSkipsWhatIsUnchangedAndTouchesNothing() throws IOException {
    Map<Path, FileTime> before = times();
    new Program().run("run", project).expect(0).says("unchanged").says("PASSED");
    Map<Path, FileTime> after = times();
    before.keySet().removeIf(file -> file.endsWith("report.html"));
    for (Map.Entry<Path, FileTime> file : before.entrySet()) {
      assertEquals(file.getValue(), after.get(file.getKey()), file.getKey().toString());
    }
  }

  private static Map<Path, FileTime> times() throws IOException {
    Map<Path, FileTime> times = new TreeMap<>();
    try (Stream<Path> files = Files.walk(project.resolve("out"))) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        if (!file.toString().contains("/.eventchain/")) {
          times.put(file, Files.getLastModifiedTime(file));
        }
      }
    }
    return times;
  }

  @Test
  void theReportIsOneFileThatNeedsNothingElse() throws IOException {
    String report = Files.readString(project.resolve("out/report.html"));
    assertFalse(report.contains("<link"), "no style sheet elsewhere");
    assertFalse(report.matches("(?s).*<script[^>]+src=.*"), "no script elsewhere");
    assertTrue(report.contains("stopped-vehicle-50"));
    assertTrue(report.contains("AEB-4"));
    assertTrue(report.contains("\"hops\":[{\"topic\":\"/carla/ego_vehicle/lidar\""));
  }

  @Test
  void theMeasuredModelHoldsTheLatencyThatTheRuleIsAbout() throws IOException {
    String model = Files.readString(project.resolve("out/chain.measured.xmi"));
    assertTrue(model.contains("<latency"), model.substring(0, 200));
    assertTrue(model.contains("name=\"waiting on /scan from ObjectDetection to TTC_Calculation\""));
    assertTrue(Files.readString(project.resolve("out/generated.ocl")).contains("250"));
  }

  @Test
  void aSlowNodeBreaksTheDesignRuleOnTheMeasuredModel() throws IOException {
    Path slow = Program.exampleIn(folder.resolve("slow"));
    Files.createDirectories(slow.resolve("model"));
    String model = Files.readString(project.resolve("out/chain.xmi"));
    Files.writeString(
        slow.resolve("model/chain.xmi"),
        model.replace(
            "<software name=\"TTC_Calculation\"",
            "<software name=\"TTC_Calculation\" worstCaseExecutionTime=\"300.0\""));
    Path out = slow.resolve("out");
    Files.createDirectories(out);
    for (String name :
        List.of(
            "generated.ocl", "components/TTC_Calculation.py", "components/Braking_Decision.py")) {
      Files.createDirectories(out.resolve(name).getParent());
      Files.copy(project.resolve("out").resolve(name), out.resolve(name));
    }
    new Program()
        .run("run", slow, "--from", "validate")
        .expect(1)
        .says("ocl.violated EventChain::BrakeCommandWithin250Milliseconds")
        .says("chain.measured.xmi:");
    String verdict = Files.readString(out.resolve("verdict.json"));
    assertTrue(verdict.contains("\"passed\" : false,"), "not better than its run: " + verdict);
    assertTrue(verdict.contains("EventChain::BrakeCommandWithin250Milliseconds"), verdict);
  }

  @InTurn
  @Test
  void noNetworkIsNeeded() throws IOException {
    Path alone = Program.exampleIn(folder.resolve("offline"));
    String[] isolated = {"unshare", "-r", "-n"};
    assumeTrue(starts(isolated), "the kernel forbids a namespace without network");
    new Program().by(isolated).run("run", alone).expect(0).says("PASSED");
  }

  private static boolean starts(String... command) {
    try {
      List<String> words = new ArrayList<>(List.of(command));
      words.add("true");
      return new ProcessBuilder(words).start().onExit().join().exitValue() == 0;
    } catch (IOException e) {
      return false;
    }
  }
}
