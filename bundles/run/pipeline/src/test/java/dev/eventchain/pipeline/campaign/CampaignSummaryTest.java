package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.campaign.result.CampaignSummary;
import dev.eventchain.simulation.verdict.CaseResult;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the findings on all cases of a campaign. */
class CampaignSummaryTest {

  @TempDir Path folder;

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
