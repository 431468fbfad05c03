package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests campaigns of the small radar example: how near the vehicle ahead may be. */
class CampaignTest {

  private static final String APPROACH =
      """
      scenario: stopped-vehicle-50
      factors:
        speed: {path: ego.speed_kmh, values: [40, 50]}
        gap: {path: "actors[0].gap_m", from: 10, to: 60, step: 25}
      boundary: {factor: gap, resolution: 2}
      """;

  @TempDir Path folder;
  private ProjectCopy copy;

  @BeforeEach
  void copyTheExample() throws IOException {
    copy = ProjectCopy.of("radar-aeb", folder);
    copy.write("approach.yaml", APPROACH);
  }

  private Program.Ended campaign(Object... more) {
    Object[] arguments = new Object[more.length + 3];
    arguments[0] = "campaign";
    arguments[1] = copy.path();
    arguments[2] = copy.path().resolve("approach.yaml");
    System.arraycopy(more, 0, arguments, 3, more.length);
    return new Program().run(arguments);
  }

  private Path results(String name) {
    return copy.path().resolve("out/campaigns/" + name);
  }

  private List<byte[]> bytes() throws IOException {
    return List.of(
        Files.readAllBytes(results("approach/cases.csv")),
        Files.readAllBytes(results("approach/cases.json")),
        Files.readAllBytes(results("approach/report.html")));
  }

  private static void assertSame(List<byte[]> expected, List<byte[]> found) {
    for (int i = 0; i < expected.size(); i++) {
      assertArrayEquals(expected.get(i), found.get(i));
    }
  }

  @InTurn
  @Test
  void aBoundaryIsFoundAndIsTheSameAfterKillsAndInParts() throws Exception {
    campaign("--dry-run").expect(0).says("6 cases, 0 of them simulated already");
    campaign().expect(0).says("14 cases: ").says("2 flips along gap");
    List<String> rows = Files.readAllLines(results("approach/cases.csv"));
    assertTrue(rows.get(0).startsWith("case,speed,gap,repetition,verdict,impact_speed_mps,end_s,"));
    assertEquals(15, rows.size());
    assertTrue(
        rows.stream().anyMatch(row -> row.matches("\\d+,50,10,1,failed,\\d.*")), rows::toString);
    assertTrue(
        rows.stream().anyMatch(row -> row.matches("\\d+,50,60,1,passed,,.*")), rows::toString);
    List<byte[]> expected = bytes();
    campaign().expect(0).says("= Simulate");
    assertSame(expected, bytes());

    for (int attempt = 1; !killOnce(); attempt++) {
      assertTrue(attempt < 10, "the program always ends before it is killed");
    }
    campaign().expect(0);
    assertSame(expected, bytes());

    copy.delete("out/campaigns/approach");
    campaign("--shard", "2/2").expect(0);
    campaign("--merge", results("approach-2-of-2"))
        .expect(2)
        .says("campaign.merge")
        .says("lack part 1 of 2");
    campaign("--shard", "1/2").expect(0);
    campaign("--merge", results("approach-2-of-2"), results("approach-1-of-2")).expect(0);
    assertSame(expected, bytes());
    copy.replace("approach.yaml", "resolution: 2", "resolution: 3");
    campaign("--merge", results("approach-1-of-2"), results("approach-2-of-2"))
        .expect(2)
        .says("another state");
  }

  @Test
  void partsComeToTheWhole() throws IOException {
    copy.endAtEightSeconds();
    copy.write(
        "approach.yaml",
        """
        scenario: stopped-vehicle-50
        factors: {gap: {path: "actors[0].gap_m", values: [10, 60]}}
        """);
    campaign().expect(1).says("2 cases: 1 passed, 1 failed");
    List<byte[]> expected = bytes();
    copy.delete("out/campaigns/approach");
    campaign("--shard", "2/2").expect(0);
    campaign("--merge", results("approach-2-of-2")).expect(2).says("lack part 1 of 2");
    campaign("--shard", "1/2").expect(0);
    campaign("--merge", results("approach-2-of-2"), results("approach-1-of-2")).expect(1);
    assertSame(expected, bytes());
  }

  @Test
  void theCampaignOfAnExampleFindsWhatItsReadmeSays() throws IOException {
    assumeTrue(Thorough.IS_ON, "takes a minute");
    ProjectCopy example = ProjectCopy.of("aeb", folder);
    Path file = example.path().resolve("campaigns/stopped-vehicle.yaml");
    new Program()
        .run("campaign", example.path(), file)
        .expect(1)
        .says("200 cases: 194 passed, 6 failed, 0 not tested, 0 ended by an error");
    List<String> rows =
        Files.readAllLines(example.path().resolve("out/campaigns/stopped-vehicle/cases.csv"));
    List<String> failed = rows.stream().filter(row -> row.contains(",failed,")).toList();
    assertEquals(6, failed.size());
    assertTrue(
        failed.stream().allMatch(row -> row.matches("\\d+,4[123]\\.\\d+,.*no full braking.*")),
        failed::toString);
  }

  /** Kills the program after it has kept a case; returns false if it had ended already. */
  private boolean killOnce() throws Exception {
    copy.delete("out/campaigns");
    Process killed =
        new Program()
            .start(
                folder.resolve("out.txt"),
                folder.resolve("err.txt"),
                "campaign",
                copy.path(),
                copy.path().resolve("approach.yaml"));
    while (killed.isAlive() && !Files.exists(results("approach/parts/000001.json"))) {
      Thread.sleep(5);
    }
    killed.destroyForcibly();
    assertTrue(killed.waitFor(60, TimeUnit.SECONDS));
    return Files.exists(results("approach/parts/000001.json"));
  }

  @Test
  void failedCasesAreFoundAndOneIsSimulatedAgain() throws IOException {
    copy.replace("approach.yaml", "boundary: {factor: gap, resolution: 2}\n", "");
    Path junit = folder.resolve("junit.xml");
    campaign("--report", "junit=" + junit)
        .expect(1)
        .says("2 of 6 cases failed, the first is case 1 (speed = 40, gap = 10)")
        .says("[campaign.case.failed]");
    String xml = Files.readString(junit);
    assertTrue(xml.contains("<testsuite name=\"cases\" tests=\"6\" failures=\"2\""), xml);
    assertTrue(xml.contains("name=\"approach: speed = 50, gap = 60\" time=\"11.700\""), xml);
    String page = Files.readString(results("approach/report.html"));
    assertTrue(page.contains("<h2>speed and gap</h2>") && page.contains("class=\"map\""), page);
    assertTrue(page.matches("(?s).*<figcaption>no impact</figcaption>.*4 values: .*"));
    Path before = folder.resolve("before");
    Projects.copy(results("approach"), before);
    copy.replace("software-base/components/Brake_Request.py", "-9.0", "-5.0");
    campaign("--compare", before).expect(1).says("0 pass now, ").says(" no longer pass, ");
    campaign("--compare", folder).expect(2).says("[campaign.comparison]");
    campaign("--case", 4).expect(0).says("case 4: speed = 50, gap = 10").says("FAILED  ");
    String scenario = Files.readString(results("approach/case-4/scenario.yaml"));
    assertTrue(scenario.contains("gap_m: 10"), scenario);
    assertTrue(Files.size(results("approach/case-4/stopped-vehicle-50.mcap")) > 10_000);
    String report = Files.readString(results("approach/case-4/report.html"));
    assertTrue(report.contains("case 4 of approach: speed = 50, gap = 10"), report);
    campaign("--case", 7).expect(2).says("There is no case 7 of 6.");
  }

  /** With nothing ahead there was no impact, which is a result of a case, but no evidence. */
  @InTurn
  @Test
  void theReportOfACaseWithNothingAheadIsNoPass() throws IOException {
    copy.write(
        "scenarios/beside.yaml",
        """
        name: beside
        title: A vehicle in the next lane
        seed: 3
        duration_s: 2
        ego: {speed_kmh: 50}
        actors:
          - {gap_m: 30, speed_kmh: 50, lateral_offset_m: 3.5}
        accept:
          no_impact: true
          judges:
            no_impact: {RAD-3: "brake with 9 m/s²"}
        """);
    copy.write(
        "approach.yaml",
        "scenario: beside\nfactors: {speed: {path: ego.speed_kmh, values: [50]}}\n");
    campaign().expect(0).says("1 case: 1 passed");
    campaign("--case", 1).expect(0).says("passed (no impact: nothing was ahead)");
    String report = Files.readString(results("approach/case-1/report.html"));
    assertTrue(report.contains("\"verdict\":\"incomplete\""), report);
    assertTrue(report.contains("passed in the campaign"), report);
  }

  @InTurn
  @Test
  void severalCampaignsOfAFileHaveATableEachAndOneConclusion() throws IOException {
    String one =
        "  %s: {scenario: stopped-vehicle-50, factors: {gap: {path: \"actors[0].gap_m\", values: [%d]}}}\n";
    copy.write(
        "approach.yaml", "campaigns:\n" + one.formatted("near", 10) + one.formatted("far", 60));
    campaign()
        .expect(1)
        .says("approach-near: 1 case: 0 passed, 1 failed")
        .says("approach-far: 1 case: 1 passed")
        .says("2 campaigns: errors in approach-near")
        .says("  at: near");
    for (String name : List.of("approach-near", "approach-far")) {
      assertEquals(2, Files.readAllLines(results(name + "/cases.csv")).size());
      assertTrue(Files.exists(results(name + "/report.html")));
    }
    campaign("--only", "far").expect(0).says("1 case: 1 passed").says("= Simulate");
    campaign("--case", 1).expect(2).says("[campaign.name]").says("--only near, --only far");
    campaign("--only", "fr", "--case", 1).expect(2).says("There is no campaign 'fr'.");
    campaign("--only", "far", "--case", 1).expect(0).says("case 1: gap = 60");
    new Program()
        .run("search", copy.path(), copy.path().resolve("approach.yaml"))
        .expect(2)
        .says("This file has several campaigns, and this is for one.");
  }

  @Test
  void factorsThatNameNothingOrDoNotFitAreFoundBeforeAnythingIsSimulated() throws IOException {
    copy.replace("approach.yaml", "ego.speed_kmh", "ego.sped_kmh");
    campaign().expect(2).says("approach.yaml:3:10").says("There is no key 'sped_kmh' here.");
    copy.replace("approach.yaml", "ego.sped_kmh", "phases_ms.Radar_Trackin");
    campaign().expect(2).says("The chain has no node 'Radar_Trackin'.").says("Radar_Tracking");
    copy.replace("approach.yaml", "phases_ms.Radar_Trackin", "ego.sped_kmh");
    copy.replace(
        "approach.yaml",
        "path: ego.sped_kmh, values: [40, 50]",
        "path: ego.speed_kmh, values: [40, 500]");
    campaign().expect(2).says("With speed = 500: 'speed_kmh' must be");
    copy.replace("approach.yaml", "values: [40, 500]", "values: [40]");
    copy.replace("approach.yaml", "actors[0].gap_m", "actors[3].gap_m");
    campaign().expect(2).says("There is no [3] for the path 'actors[3].gap_m', but [0].");
    copy.replace("approach.yaml", "actors[3].gap_m", "ego.speed_kmh");
    campaign().expect(2).says("Two factors have 'ego.speed_kmh'.");
    copy.replace("approach.yaml", "stopped-vehicle-50", "stoped-vehicle-50");
    campaign().expect(2).says("no scenario 'stoped-vehicle-50'").says("stopped-vehicle-50");
  }

  @InTurn
  @Test
  void casesThatEndByAnErrorAreCases() throws IOException {
    copy.replace("approach.yaml", "boundary: {factor: gap, resolution: 2}\n", "");
    String component = "software-base/components/Collision_Warning.py";
    copy.replace(
        component,
        "    def execute(self, ttc):\n",
        "    def execute(self, ttc):\n        assert ttc > 1.5\n");
    campaign().expect(1).says("6 cases: ").says("[campaign.case.error]").says("ended by an error");
  }

  /** Each value is possible; but a wheelbase of 3.6 m is too long for 4 m. */
  @InTurn
  @Test
  void aCombinationThatIsNoScenarioIsACase() throws IOException {
    copy.write(
        "approach.yaml",
        """
        scenario: stopped-vehicle-50
        factors:
          length: {path: ego.length_m, values: [4.5, 4]}
          wheelbase: {path: ego.wheelbase_m, values: [2.7, 3.6]}
        """);
    campaign()
        .expect(1)
        .says("1 of 4 cases ended")
        .says("(length = 4, wheelbase = 3.6): no scenario: Its wheelbase");
  }

  @Test
  void whatIsDrawnIsShownAsPoints() throws IOException {
    copy.write(
        "approach.yaml",
        """
        scenario: stopped-vehicle-50
        factors:
          speed: {path: ego.speed_kmh, normal: {mean: 50, deviation: 9, within: [30, 60]}}
          gap: {path: "actors[0].gap_m", uniform: [50, 70]}
        sampling: {latin_hypercube: 3}
        """);
    campaign().expect(0).says("3 cases: 3 passed");
    String page = Files.readString(results("approach/report.html"));
    assertEquals(4, page.split("<circle class=\"passed\"", -1).length, page);
  }

  /** The vehicle never comes as near as the formula is about. */
  @Test
  void whatWasTestedInNoCaseIsFound() throws IOException {
    copy.write(
        "scenarios/far.yaml",
        """
        name: far
        title: Nothing comes near
        duration_s: 2
        ego: {speed_kmh: 30}
        actors: [{gap_m: 100, speed_kmh: 30}]
        accept:
          formulas:
            - {requirements: [RAD-2], formula: "always (gap < 1 m implies /cluster/collision_warning.data)"}
        """);
    copy.write(
        "approach.yaml",
        "scenario: far\nfactors: {speed: {path: ego.speed_kmh, values: [20, 30]}}\n");
    campaign()
        .expect(1)
        .says("2 cases: 0 passed, 0 failed, 2 not tested")
        .says("2 of 2 cases not tested, the first is case 1 (speed = 20)")
        .says("[campaign.case.untested]")
        .says("In none of 2 cases, 'always (gap < 1 m implies")
        .says("[campaign.criterion.untested]");
  }

  /** A radar that sees 8 m sees the vehicle too late. */
  @Test
  void numbersOfTheBenchAreFactors() throws IOException {
    copy.write(
        "approach.yaml",
        """
        scenario: stopped-vehicle-50
        factors:
          reach: {path: "bench:inputs.radar.reach.value", values: [8, 150]}
        """);
    campaign().expect(1).says("1 of 2 cases failed, the first is case 1 (reach = 8): ");
    campaign("--case", 1).expect(0).says("FAILED  no impact");
    copy.replace(
        "approach.yaml", "bench:inputs.radar.reach.value", "bench:inputs.radr.reach.value");
    campaign().expect(2).says("[campaign.factor]");
  }
}
