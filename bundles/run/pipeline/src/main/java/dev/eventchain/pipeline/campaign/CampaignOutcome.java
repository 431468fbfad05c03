package dev.eventchain.pipeline.campaign;

import static java.util.stream.Collectors.joining;

import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * The outcome of a campaign.
 *
 * @param outcome the findings, with the exit code
 * @param text what became of the cases, for people; empty if none was simulated
 */
public record CampaignOutcome(Outcome outcome, String text) {

  /** Returns the outcome of several campaigns of a file, with the worst exit code of all. */
  static CampaignOutcome of(List<CampaignPlan> plans, List<CampaignOutcome> each) {
    Outcome outcome =
        each.stream().map(CampaignOutcome::outcome).reduce(Outcome::and).orElseThrow();
    String texts =
        IntStream.range(0, plans.size())
            .mapToObj(i -> plans.get(i).name() + ": " + each.get(i).text())
            .collect(joining());
    List<String> wanting =
        IntStream.range(0, plans.size())
            .filter(i -> each.get(i).outcome().exitCode() != ExitCode.FINE)
            .mapToObj(i -> plans.get(i).name())
            .toList();
    String conclusion = wanting.isEmpty() ? "no errors" : "errors in " + String.join(", ", wanting);
    return new CampaignOutcome(
        outcome,
        texts + String.format(Locale.ROOT, "%d campaigns: %s%n", plans.size(), conclusion));
  }
}
