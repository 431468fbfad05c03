package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Trial;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.result.BoundarySearch;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.campaign.result.CampaignSummary;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests where a boundary is searched, and what is said about it, without a simulation. */
class BoundaryTest {

  @TempDir Path folder;

  private CampaignPlan plan(String boundary) throws IOException {
    String text =
        """
        scenario: s
        factors:
          speed: {path: x, values: [1, 2]}
          gap: {path: y, values: [0, 8, 16, 24]}
        boundary: {factor: gap, %s}
        """;
    return CampaignReader.read(
            Files.writeString(folder.resolve("a.yaml"), text.formatted(boundary)))
        .get(0);
  }

  private static CampaignRow row(int speed, double gap, Label label, CriterionMargin... criteria) {
    List<BigDecimal> values = List.of(BigDecimal.valueOf(speed), BigDecimal.valueOf(gap));
    return new CampaignRow(
        new CampaignCase(values, 1),
        new CaseResult(label, "", List.of(criteria), OptionalDouble.empty(), 1));
  }

  /** Returns cases 8 apart, a letter each: passed, failed, untested, error; a dot for none. */
  private static Stream<CampaignRow> line(int speed, String letters) {
    return IntStream.range(0, letters.length())
        .filter(i -> letters.charAt(i) != '.')
        .mapToObj(i -> row(speed, 8 * i, label(letters.charAt(i))));
  }

  private static Label label(char letter) {
    return Arrays.stream(Label.values())
        .filter(label -> Character.toLowerCase(label.name().charAt(0)) == letter)
        .findFirst()
        .orElseThrow();
  }

  private static String next(CampaignPlan plan, List<CampaignRow> rows) {
    List<String> next =
        new BoundarySearch(plan.boundary().orElseThrow())
            .next(rows).stream().map(each -> each.values().get(1).toPlainString()).toList();
    return String.join(" ", next);
  }

  /** Flips at the ends, flips twice, and a case that has no verdict. */
  @ParameterizedTest
  @CsvSource(
      value = {
        "pppp | ''",
        "ffff | ''",
        "pfff | 4",
        "pppf | 20",
        "pfpf | 4 12 20",
        "uppp | 4",
        "fupp | 4 12",
        "fepp | 8",
        "eeee | ''",
      },
      delimiter = '|')
  void theDistanceOfNeighboursWithDifferentVerdictsIsHalved(String letters, String next)
      throws IOException {
    assertEquals(next, next(plan("resolution: 2"), line(1, letters).toList()));
    assertEquals("", next(plan("resolution: 16"), line(1, letters).toList()));
  }

  @ParameterizedTest
  @CsvSource(
      value = {
        "pppp | pppp | 0 flips along gap; 2 of 2 combinations of the others: 2 passed throughout",
        "pfff | ffff | 1 flip along gap, to within 8; 1 of 2 combinations of the others: 1 failed throughout",
        "pfpp | uuuu | 2 flips along gap, to within 8; 1 of 2 combinations of the others: 1 not tested throughout",
        "pfff | eepe | 1 flip along gap, to within 8; 1 of 2 combinations of the others: 1 with fewer than two verdicts",
        "pefp | pppf | 3 flips along gap, to within 8, except for 1, where no case between has a verdict; ",
      },
      delimiter = '|')
  void whatDoesNotFlipIsSaid(String one, String two, String said) throws IOException {
    List<CampaignRow> rows = Stream.concat(line(1, one), line(2, two)).toList();
    String text = new CampaignSummary(plan("resolution: 8"), rows).text();
    String[] words = said.split("; ?", -1);
    String rest =
        words[1].isEmpty() ? "" : "no flip between the values of gap in " + words[1] + "\n";
    assertEquals(words[0] + "\n" + rest, text.substring(text.indexOf('\n') + 1));
  }

  /** The case fails elsewhere, by another criterion. */
  @Test
  void theBoundaryMayBeThatOfOneCriterion() throws IOException {
    CampaignPlan plan = plan("resolution: 2, criterion: the lane");
    List<CampaignRow> rows =
        List.of(
            row(1, 0, Label.FAILED, of("the lane is kept", Label.PASSED)),
            row(1, 8, Label.PASSED, of("the lane is kept", Label.PASSED)),
            row(1, 16, Label.FAILED, of("the lane is kept", Label.FAILED)),
            row(1, 20, Label.PASSED));
    assertEquals("12", next(plan, rows));
    assertEquals(
        "1 flip of 'the lane' along gap, to within 2, except for 1, where no case between has a"
            + " verdict",
        new CampaignSummary(plan, rows).text().lines().skip(1).findFirst().orElseThrow());
  }

  /** Some cases are to fail; a combination in which none passes is no pass. */
  @ParameterizedTest
  @CsvSource(
      value = {
        "pfpp | ffff | PASSED passed up to 0, failed from 8; failed up to 8, passed from 16 | SKIPPED no flip: failed throughout",
        "ffff | f... | FAILED no flip: failed throughout | FAILED no flip: fewer than two verdicts",
        "pppp | pppu | PASSED no flip: passed throughout | FAILED passed up to 16, not tested from 24",
      },
      delimiter = '|')
  void eachCombinationIsATest(String one, String two, String first, String second)
      throws IOException {
    List<CampaignRow> rows = Stream.concat(line(1, one), line(2, two)).toList();
    List<Trial> trials = new CampaignSummary(plan("resolution: 8"), rows).trials();
    assertEquals(
        List.of("a: speed = 1, along gap", "a: speed = 2, along gap"),
        trials.stream().map(Trial::name).toList());
    assertEquals(
        List.of(first, second), trials.stream().map(it -> it.outcome() + " " + it.text()).toList());
  }

  private static CriterionMargin of(String name, Label label) {
    return new CriterionMargin(name, label, OptionalDouble.empty(), "");
  }

  @Test
  void oneValueHasNoBoundary() throws IOException {
    Path file = folder.resolve("one.yaml");
    Files.writeString(
        file,
        """
        scenario: s
        factors: {f: {path: p, values: [1]}}
        boundary: {factor: f, resolution: 1}
        """);
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> CampaignReader.read(file));
    assertEquals("campaign.value.range", refused.diagnostics().get(0).id());
    assertEquals(
        "'f' has one value, and a boundary lies between two.",
        refused.diagnostics().get(0).message());
  }
}
