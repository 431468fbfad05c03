package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.simulation.verdict.CaseResult;
import java.util.Comparator;

/** A case with what became of it. */
record CampaignRow(CampaignCase id, CaseResult result) {

  static final Comparator<CampaignRow> ORDER =
      Comparator.comparing(CampaignRow::id, CampaignCase.ORDER);

  boolean is(CaseResult.Label label) {
    return result.label() == label;
  }
}
