package dev.eventchain.pipeline.campaign;

import dev.eventchain.simulation.verdict.CaseResult;
import java.util.Comparator;

/** A case with what became of it. */
record CampaignRow(CampaignCase id, CaseResult result) {

  static final Comparator<CampaignRow> ORDER =
      Comparator.comparing(CampaignRow::id, CampaignCase.ORDER);

  /** Returns the smallest margin of a criterion that was judged; infinite if there is none. */
  double nearest() {
    return result.criteria().stream()
        .flatMapToDouble(each -> each.margin().stream())
        .min()
        .orElse(Double.POSITIVE_INFINITY);
  }

  boolean is(CaseResult.Label label) {
    return result.label() == label;
  }
}
