package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.simulation.verdict.CaseResult;
import java.util.Comparator;
import java.util.Locale;

/** A case with what became of it. */
public record CampaignRow(CampaignCase id, CaseResult result) {

  static final Comparator<CampaignRow> ORDER =
      Comparator.comparing(CampaignRow::id, CampaignCase.ORDER);

  /** Returns the verdict as tables have it. */
  String word() {
    return result.label().name().toLowerCase(Locale.ROOT);
  }

  /** Returns why it is not passed, or what may be misread if it is; empty if there is nothing. */
  String reason() {
    return result.nothingAhead() ? "no impact: nothing was ahead" : result.reason();
  }

  /** Returns the verdict with its reason. */
  public String words() {
    return words(result.label()) + (reason().isEmpty() ? "" : " (" + reason() + ")");
  }

  /** Returns a verdict for people. */
  public static String words(CaseResult.Label label) {
    return switch (label) {
      case PASSED -> "passed";
      case FAILED -> "failed";
      case UNTESTED -> "not tested";
      case ERROR -> "error";
    };
  }

  public boolean is(CaseResult.Label label) {
    return result.label() == label;
  }
}
