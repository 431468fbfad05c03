package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.documents.YamlLayout;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.pipeline.campaign.plan.Purpose;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests campaigns that are written about files in OpenSCENARIO XML. */
class OpenScenarioCampaignsTest {

  private static final Path FOLDER = Path.of("src/test/resources/openscenario");

  @TempDir Path output;

  private Path write(String name, Purpose purpose) {
    return OpenScenarioCampaigns.write(FOLDER.resolve(name), List.of("no_impact"), output, purpose);
  }

  private static List<List<BigDecimal>> cases(CampaignPlan plan) {
    return new CaseList(plan).cases().stream().map(CampaignCase::values).toList();
  }

  private static CampaignPlan plan(Path file) {
    return CampaignReader.read(file).get(0);
  }

  private static List<BigDecimal> numbers(String... numbers) {
    return List.of(numbers).stream().map(BigDecimal::new).toList();
  }

  /**
   * The number 10 is not allowed; of what has no two bounds or follows from others, none varies.
   */
  @Test
  void numbersVaryBetweenTheirConstraints() throws IOException {
    Path file = write("bounded.xosc", Purpose.CAMPAIGN);
    assertEquals(
        """
        scenario: bounded-scenario.yaml
        factors:
          speed:
            path: openscenario.parameters.speed
            uniform: [10.00002, 30]
          lane_shift:
            path: openscenario.parameters.lane.shift
            values: [-1, 0, 1]
        sampling: {halton: 100}
        """,
        Files.readString(file));
    assertEquals(100, cases(plan(file)).size());
    String scenario = Files.readString(output.resolve("openscenario/bounded-scenario.yaml"));
    assertTrue(scenario.contains("parameters: {speed: 20, lane.shift: 0}"), scenario);
    assertTrue(scenario.contains("accept: {no_impact: true}"), scenario);
    assertTrue(scenario.contains("openscenario/bounded.xosc"), scenario);
  }

  @Test
  void aSearchGoesBetweenTheBounds() throws IOException {
    Path file = write("bounded.xosc", Purpose.SEARCH);
    assertTrue(!Files.readString(file).contains("sampling"));
    assertEquals(2, CampaignReader.readForSearch(file).get(0).factors().size());
  }

  @Test
  void combinationsAreAGrid() throws IOException {
    Path file = write("grid.xosc", Purpose.CAMPAIGN);
    List<List<BigDecimal>> cases = cases(plan(file));
    assertEquals(6, cases.size());
    assertEquals(numbers("14.5", "-1"), cases.get(0));
    assertEquals(numbers("15.5", "1"), cases.get(5));
    String scenario = Files.readString(output.resolve("openscenario/grid-scenario.yaml"));
    assertTrue(scenario.contains("{word: b, speed: 14.5, lane.shift: -1}"), scenario);
  }

  @Test
  void setsOfValuesStayTogether() {
    List<List<BigDecimal>> cases = cases(plan(write("sets.xosc", Purpose.CAMPAIGN)));
    assertEquals(List.of(numbers("12", "1"), numbers("12.5", "0")), cases);
    assertEquals(
        "campaign.factor: The cases of this file are not all combinations of their values, between"
            + " which a search could go.",
        refusal("sets.xosc", Purpose.SEARCH));
  }

  @Test
  void somethingHasToVary() {
    assertTrue(
        refusal("single.xosc", Purpose.CAMPAIGN).startsWith("campaign.empty: Nothing varies"));
    assertEquals(
        "campaign.factor: 'word' differs between the cases, and its values are no numbers.",
        refusal("words.xosc", Purpose.CAMPAIGN));
    assertTrue(refusal("missing.xosc", Purpose.CAMPAIGN).startsWith("file.missing"));
  }

  @Test
  void somethingHasToBeRequired() {
    Diagnostic finding =
        assertThrows(
                DiagnosticException.class,
                () ->
                    OpenScenarioCampaigns.write(
                        FOLDER.resolve("grid.xosc"), List.of(), output, Purpose.CAMPAIGN))
            .diagnostics()
            .get(0);
    assertEquals("scenario.key.missing", finding.id());
  }

  private String refusal(String name, Purpose purpose) {
    Diagnostic finding =
        assertThrows(DiagnosticException.class, () -> write(name, purpose)).diagnostics().get(0);
    return finding.id() + ": " + finding.message();
  }

  private CampaignPlan plan(String name, String more) throws IOException {
    Path file = output.resolve("campaign.yaml");
    Path scenario = FOLDER.resolve(name).toAbsolutePath();
    return plan(Files.writeString(file, "scenario: " + scenario + "\n" + more));
  }

  private static String written(CampaignPlan plan) {
    return YamlLayout.of(plan.played().orElseThrow().written("x.xosc", plan.paths()));
  }

  /** What a campaign file says of a file is the same as what is written about it. */
  @ParameterizedTest
  @ValueSource(strings = {"bounded.xosc", "grid.xosc", "sets.xosc"})
  void aCampaignFileNamesAFile(String name) throws IOException {
    CampaignPlan plan = plan(name, "accept: [no_impact]\n");
    CampaignPlan expected = plan(write(name, Purpose.CAMPAIGN));
    assertEquals(cases(expected), cases(plan));
    assertEquals(expected.names(), plan.names());
    assertEquals(expected.paths().toList(), plan.paths().toList());
    assertEquals(List.of(), plan.tables());
    String scenario =
        Files.readString(output.resolve("openscenario/" + name.replace(".xosc", "-scenario.yaml")));
    assertEquals(
        scenario.replaceAll("file: .*", "file: x.xosc"),
        written(plan).replaceAll("file: .*", "file: x.xosc"));
  }

  @Test
  void factorsMayBeOtherParametersThanThoseThatVary() throws IOException {
    String factors =
        """
        accept: [maximal_impact_speed_kmh=10]
        factors:
          onlyLeast: {values: [3, 4]}
          turned: {path: openscenario.parameters.lane.shift, values: [0, 1]}
        """;
    CampaignPlan plan = plan("bounded.xosc", factors);
    assertEquals(4, cases(plan).size());
    assertEquals(
        List.of("openscenario.parameters.onlyLeast", "openscenario.parameters.lane.shift"),
        plan.paths().toList());
    String scenario = written(plan);
    assertTrue(scenario.contains("onlyLeast: 5"), scenario);
    assertTrue(scenario.contains("accept: {maximal_impact_speed_kmh: 10.0}"), scenario);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "bounded.xosc | '' | campaign.key.missing: An OpenSCENARIO file does not say",
        "bounded.xosc | 'accept: no_impact' | campaign.value.type",
        "single.xosc | 'accept: [no_impact]' | campaign.empty: Nothing varies in this file",
        "words.xosc | 'accept: [no_impact]' | campaign.factor: 'word' differs",
        "missing.xosc | 'accept: [no_impact]' | file.missing",
        "other.yaml | 'accept: [no_impact]' | campaign.key.missing",
      })
  void whatCannotBeACampaignIsRefused(String name, String more, String finding) {
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> plan(name, more + "\n"));
    Diagnostic first = refused.diagnostics().get(0);
    assertTrue((first.id() + ": " + first.message()).startsWith(finding), refused::getMessage);
  }
}
