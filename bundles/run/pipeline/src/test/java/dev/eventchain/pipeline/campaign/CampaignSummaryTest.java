package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.campaign.result.CampaignSummary;
import dev.eventchain.pipeline.campaign.result.CampaignTable;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the findings on all cases of a campaign. */
class CampaignSummaryTest {

  @TempDir Path folder;

  /** There was no impact, as without any software. */
  @Test
  void thatNothingWasAheadIsSaid() throws IOException {
    String text = "scenario: s\nfactors: {f: {path: p, values: [1, 2]}}\n";
    CampaignPlan plan =
        CampaignReader.read(Files.writeString(folder.resolve("a.yaml"), text)).get(0);
    List<CampaignRow> rows = List.of(row(1, false), row(2, true));
    CampaignSummary summary = new CampaignSummary(plan, rows);
    assertTrue(summary.text().contains("\n1 of the passed had nothing ahead: "), summary.text());
    assertEquals("no impact: nothing was ahead", summary.trials().get(1).text());
    String table = new String(new CampaignTable(plan.names(), rows).csv(), StandardCharsets.UTF_8);
    assertEquals(
        List.of("1,1,1,passed,,1.0,", "2,2,1,passed,,1.0,no impact: nothing was ahead"),
        table.lines().skip(1).toList());
    assertFalse(new CampaignSummary(plan, rows.subList(0, 1)).text().contains("ahead"));
  }

  private static CampaignRow row(int value, boolean nothingAhead) {
    return new CampaignRow(
        new CampaignCase(List.of(BigDecimal.valueOf(value)), 1),
        new CaseResult(Label.PASSED, "", List.of(), OptionalDouble.empty(), 1, nothingAhead));
  }

  /** Nearly all of its cells would be empty. */
  @Test
  void drawnValuesAreNoTable() throws IOException {
    String text =
        """
        scenario: s
        factors: {f: {path: p, %s}, g: {path: q, values: [1, 2]}}
        sampling: {halton: 2}
        """;
    List<CampaignRow> rows =
        IntStream.of(1, 2)
            .mapToObj(it -> new CampaignCase(List.of(BigDecimal.valueOf(it), BigDecimal.ONE), 1))
            .map(id -> new CampaignRow(id, CaseResult.error("x")))
            .toList();
    for (String values : List.of("values: [1, 2]", "uniform: [1, 2]")) {
      Path file = Files.writeString(folder.resolve("a.yaml"), text.formatted(values));
      String said = new CampaignSummary(CampaignReader.read(file).get(0), rows).text();
      assertEquals(values.startsWith("values"), said.contains("f \\ g"), said);
    }
  }

  /** The reason of an error is a sentence of its own, and the one of a criterion is none. */
  @Test
  void aReasonInASentenceEndsWithOneFullStop() throws IOException {
    String text = "scenario: s\nfactors: {f: {path: p, values: [1]}}\n";
    CampaignPlan plan =
        CampaignReader.read(Files.writeString(folder.resolve("a.yaml"), text)).get(0);
    CampaignCase id = new CampaignCase(List.of(BigDecimal.ONE), 1);
    List<CampaignRow> rows =
        List.of(new CampaignRow(id, CaseResult.error("'stops' is set twice.")));
    List<Diagnostic> found =
        new CampaignSummary(plan, rows).findings(SourceLocation.of(plan.file()));
    assertEquals(
        List.of(
            "1 of 1 case ended by an error, the first is case 1 (f = 1): 'stops' is set twice."),
        found.stream().map(Diagnostic::message).toList());
  }
}
