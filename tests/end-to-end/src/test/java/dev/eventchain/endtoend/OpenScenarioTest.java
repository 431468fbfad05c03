package dev.eventchain.endtoend;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Repository;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests scenarios in OpenSCENARIO XML, and suites, with the emergency braking of the paper. */
class OpenScenarioTest {

  private static final Path FILES =
      Repository.ROOT.resolve("bundles/robot/simulation/src/test/resources/openscenario");

  @TempDir Path folder;
  private FinishedRun project;

  @BeforeEach
  void finish() throws IOException {
    project = FinishedRun.in(folder);
  }

  private Program.Ended simulate(Object... more) {
    Object[] arguments = new Object[more.length + 2];
    arguments[0] = "simulate";
    arguments[1] = project.path();
    System.arraycopy(more, 0, arguments, 2, more.length);
    return new Program().run(arguments);
  }

  @Test
  void theCasesOfAFileAreJudgedByGivenCriteria() {
    // At 70 km/h, the thresholds of the paper are not enough before a stationary car.
    simulate(
            "--no-strength",
            "--scenario-file",
            FILES.resolve("rear-end-cases.xosc"),
            "--accept",
            "no_impact")
        .expect(1)
        .says("passed  rear-end-cases-1 ")
        .says("FAILED  rear-end-cases-5 ")
        .says("the ego's front hit Target")
        .says("passed  rear-end-cases-6 ")
        .says("5 of 6 scenarios passed");
  }

  @Test
  void acceptanceIsNotInTheFile() {
    Path file = FILES.resolve("rear-end.xosc");
    simulate("--scenario-file", file).expect(2).says("Add --accept no_impact");
    simulate("--scenario-file", file, "--accept", "no_impackt")
        .expect(2)
        .says("Did you mean `no_impact`?");
    simulate("--accept", "no_impact").expect(2).says("--accept needs --scenario-file");
  }

  @Test
  void aFileIsACampaign() throws IOException {
    Path cases = FILES.resolve("rear-end-cases.xosc");
    campaign(cases, "--accept", "no_impact")
        .expect(1)
        .says("6 cases: 5 passed, 1 failed")
        .says("  speed_kph \\ target_kph       0      20")
        .says("                      70  FAILED  passed");
    campaign(FILES.resolve("rear-end.xosc"), "--accept", "no_impact")
        .expect(2)
        .says("Nothing varies in this file")
        .says("campaign.empty");
    campaign(cases).expect(2).says("Add --accept no_impact");
    campaign(cases, "--accept", "no_impact", "--engine", "ray")
        .expect(2)
        .says("--engine needs a campaign file");
    Path file = project.path().resolve("out/openscenario/rear-end-cases.yaml");
    campaign(file, "--accept", "no_impact").expect(2).says("--accept needs a file");
  }

  /** What a search finds leads to the file that it plays, from the results and when it is kept. */
  @InTurn
  @Test
  void aSearchGoesThroughTheParametersOfAFile() throws IOException {
    Path file = folder.resolve("far.yaml");
    Files.writeString(
        file,
        """
        scenario: %s
        accept: [no_impact]
        factors:
          speed_kph: {values: [30, 70]}
          target_kph: {values: [0, 20]}
        search: {runs: 10, seeds: 1, stop: first_failure}
        """
            .formatted(FILES.resolve("rear-end.xosc").toAbsolutePath()));
    campaign(file, "--engine", "ray").expect(2).says("[campaign.engine]").says("by its path from");
    campaigns("search", file, "--keep")
        .expect(1)
        .says("found/rear-end-found-1.yaml: speed_kph = 70")
        .says("[search.found]")
        .says("Kept: ");
    Path found = project.path().resolve("out/searches/far/found/rear-end-found-1.yaml");
    Path kept = project.path().resolve("scenarios/found/rear-end-found-1.yaml");
    for (Path each : List.of(found, kept)) {
      simulate("--no-strength", "--scenario-file", each).says("FAILED  rear-end-found-1");
    }
    campaigns("campaign", file, "--case", 1).expect(2).says("There is no case 1 of 0");
    campaign(file).expect(1).says("4 cases: 3 passed, 1 failed");
    campaigns("campaign", file, "--case", 3).expect(0).says("FAILED  no impact");
    Path replayed = project.path().resolve("out/campaigns/far/case-3/scenario.yaml");
    simulate("--no-strength", "--scenario-file", replayed).says("FAILED  rear-end");
  }

  /** From each output folder, another path leads to the file. */
  @InTurn
  @Test
  void partsInOtherFoldersArePutTogether() throws IOException {
    Path file = folder.resolve("parts.yaml");
    Path played = FILES.resolve("rear-end-cases.xosc").toAbsolutePath();
    Files.writeString(file, "scenario: " + played + "\naccept: [no_impact]\n");
    Path deep = folder.resolve("one/two");
    Path near = folder.resolve("near");
    campaigns("campaign", file, "--shard", "1/2", "-o", deep).expect(0);
    campaigns("campaign", file, "--shard", "2/2", "-o", near).expect(0);
    campaigns(
            "campaign",
            file,
            "--merge",
            deep.resolve("campaigns/parts-1-of-2"),
            near.resolve("campaigns/parts-2-of-2"))
        .expect(1)
        .says("6 cases: 5 passed, 1 failed");
  }

  /** The file says nothing of criteria; one case is slower than what it is asked for. */
  @Test
  void criteriaOfASuiteAreGivenByTagsAndValues() throws IOException {
    Path suite = folder.resolve("tagged.yaml");
    String text =
        """
        criteria:
          - {tags: [rear-end], accept: {no_impact: true}}
          - tags: [rear-end, fast]
            where: [speed_kph > 40]
            accept: {formulas: [{formula: eventually ego.acceleration <= -100 m/s2}]}
        campaigns:
          near:
            tags: [fast, rear-end]
            scenario: %s
            factors: {speed_kph: {values: [30, 50]}}
        """
            .formatted(FILES.resolve("rear-end.xosc").toAbsolutePath());
    Files.writeString(suite, text);
    simulate("--suite", suite)
        .expect(1)
        .says("2 cases: 1 passed, 1 failed")
        .says("(speed_kph = 50): eventually ego.acceleration <= -100 m/s2");
    Files.writeString(suite, text.replace("speed_kph > 40", "speed_kph > 60"));
    simulate("--suite", suite).expect(2).says("[campaign.criteria]");
    Files.writeString(suite, text.replace("tags: [rear-end]", "tags: [rear_end]"));
    simulate("--suite", suite).expect(2).says("No campaign has the tag 'rear_end'. [campaign.tag]");
  }

  private Program.Ended campaign(Path file, Object... more) {
    return campaigns("campaign", file, more);
  }

  private Program.Ended campaigns(String command, Path file, Object... more) {
    Object[] arguments = new Object[more.length + 3];
    arguments[0] = command;
    arguments[1] = project.path();
    arguments[2] = file;
    System.arraycopy(more, 0, arguments, 3, more.length);
    return new Program().run(arguments);
  }

  @Test
  void aSuiteIsACampaignFileWithItsOwnScenarios() throws IOException {
    for (String name : List.of("rear-end.xosc", "straight.xodr", "catalogs/vehicles.xosc")) {
      Path to = folder.resolve("suite").resolve(name);
      Files.createDirectories(to.getParent());
      Files.copy(FILES.resolve(name), to);
    }
    Files.writeString(
        folder.resolve("suite/ahead.yaml"),
        """
        name: ahead
        title: A car ahead
        openscenario: {file: rear-end.xosc, parameters: {speed_kph: 50, aside: 0}}
        accept: {no_impact: true}
        """);
    Path map = folder.resolve("suite/straight.xodr");
    Files.writeString(map, Files.readString(map).replace("<planView>", "<planVew/><planView>"));
    Path suite = folder.resolve("suite/suite.yaml");
    Files.writeString(
        suite,
        """
        scenario: ahead.yaml
        factors:
          speed: {path: openscenario.parameters.speed_kph, values: [30, 70]}
          aside: {path: openscenario.parameters.aside, values: [0, 3.5]}
        points: {source: Protocol 1, most: 2, at_impact: if impact < 100 then 0.25 else 0}
        """);
    simulate("--suite", suite)
        .expect(1)
        .says("4 cases: 3 passed, 1 failed")
        .says("points: 6.5 of 8 (Protocol 1)")
        .says("  speed \\ aside           0       3.5")
        .says("             30    passed 2  passed 2")
        .says("             70  FAILED 0.5  passed 2")
        .says("road.element.unknown");
    Files.writeString(folder.resolve("suite/rear-end.xosc"), "<OpenSCENARIO>");
    simulate("--suite", suite).expect(2).says("osc.syntax");
    simulate("--suite", "un-r153").expect(2).says("Did you mean 'un-r152'?");
  }

  /** The figures are in the page about suites. */
  @InTurn
  @Test
  void theSuiteOfTheRegulationSaysWhatThePapersThresholdsReach() {
    simulate("--suite", "un-r152")
        .expect(1)
        .says("un-r152-stationary_target: 27 cases: 15 passed, 12 failed")
        .says("un-r152-moving_target: 12 cases: 12 passed")
        .says("un-r152-bend_ahead: 6 cases: 2 passed, 4 failed")
        .says("8 campaigns: errors in un-r152-stationary_target, un-r152-bend_ahead");
  }

  /** As above. */
  @InTurn
  @Test
  void theSuiteOfTheRegulationHasPedestrians() {
    simulate("--suite", "un-r152-pedestrian")
        .expect(1)
        .says("un-r152-pedestrian-crossing: 9 cases: 6 passed, 3 failed")
        .says("un-r152-pedestrian-crossing_01: 10 cases: 2 passed, 8 failed")
        .says("un-r152-pedestrian-beside: 6 cases: 6 passed");
  }

  /** As above. */
  @InTurn
  @Test
  void theSuiteOfEuroNcapHasCarsAtJunctions() {
    simulate("--suite", "euro-ncap-2026-junction")
        .expect(1)
        .says("euro-ncap-2026-junction-ccftap: 9 cases: 8 passed, 1 failed")
        .says("euro-ncap-2026-junction-cccscp: 50 cases: 0 passed, 50 failed")
        .says("euro-ncap-2026-junction-turns_in_a_gap: 8 cases: 7 passed, 1 failed")
        .says("euro-ncap-2026-junction-crossed_before: 12 cases: 12 passed");
  }

  /** As above. */
  @InTurn
  @Test
  void theSuiteOfEuroNcapHasPedestriansAndBicyclists() {
    simulate("--suite", "euro-ncap-2023-vru")
        .expect(1)
        .says("euro-ncap-2023-vru-cpna: 22 cases: 9 passed, 13 failed")
        .says("euro-ncap-2023-vru-cpla: 9 cases: 9 passed")
        .says("euro-ncap-2023-vru-cbna: 11 cases: 0 passed, 11 failed")
        .says("euro-ncap-2023-vru-cbla: 8 cases: 8 passed")
        .says("euro-ncap-2023-vru-beside_bicycle: 6 cases: 6 passed");
  }

  /** As above. */
  @InTurn
  @Test
  void theSuiteOfEuroNcapCountsPoints() {
    simulate("--suite", "euro-ncap-2023-c2c")
        .expect(1)
        .says("points: 70 of 70 (Euro NCAP Safety Assist 9.1, AEB in CCRs)")
        .says("points: 75 of 75 (Euro NCAP Safety Assist 9.1, AEB in CCRm)")
        .says("             12  passed  FAILED");
  }
}
