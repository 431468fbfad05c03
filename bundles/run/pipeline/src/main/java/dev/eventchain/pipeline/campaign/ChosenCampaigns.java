package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * The choice of campaigns of a file.
 *
 * @param only the name of the only one; empty for all
 * @param needsOne whether several make no sense
 */
record ChosenCampaigns(Optional<String> only, boolean needsOne) {

  /**
   * Returns those of all campaigns of a file that are chosen.
   *
   * @throws DiagnosticException (INPUT) if there is none of this name, or if it takes a name to
   *     have one
   */
  List<CampaignPlan> of(List<CampaignPlan> all) {
    List<CampaignPlan> chosen =
        all.stream().filter(plan -> only.isEmpty() || plan.part().equals(only)).toList();
    List<String> names = all.stream().flatMap(plan -> plan.part().stream()).toList();
    Path file = all.get(0).file();
    if (chosen.isEmpty()) {
      String message =
          names.isEmpty()
              ? "The campaign of this file has no name; leave out --only."
              : "There is no campaign '" + only.orElseThrow() + "'.";
      throw refused(message, file, NearestName.hint(only.orElseThrow(), names));
    }
    if (needsOne && chosen.size() > 1) {
      String message = "This file has several campaigns, and this is for one.";
      throw refused(message, file, "Name one: --only " + String.join(", --only ", names));
    }
    return chosen;
  }

  private static DiagnosticException refused(String message, Path file, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(CampaignRules.NAME, message, SourceLocation.of(file)).withHint(hint));
  }
}
