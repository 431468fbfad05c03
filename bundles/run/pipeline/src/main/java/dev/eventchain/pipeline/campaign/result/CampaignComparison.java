package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/** The cases of a campaign beside those of an earlier one, by their values. */
public final class CampaignComparison {

  /** A case of both campaigns with different verdicts. */
  record Change(CampaignRow before, CampaignRow now) {

    boolean isBetter() {
      return now.is(Label.PASSED);
    }
  }

  private final List<Change> changes = new ArrayList<>();
  private int same;
  private int added;

  private CampaignComparison(Map<CampaignCase, CampaignRow> before, List<CampaignRow> now) {
    for (CampaignRow row : now) {
      CampaignRow other = before.get(row.id());
      if (other == null) {
        added++;
      } else if (other.is(Label.PASSED) == row.is(Label.PASSED)) {
        same++;
      } else {
        changes.add(new Change(other, row));
      }
    }
  }

  /** The cases of an earlier campaign. */
  public record Earlier(Path folder, List<CampaignRow> rows) {

    /**
     * Returns the comparison with cases of now.
     *
     * @throws DiagnosticException (INPUT) {@code campaign.comparison} if they have nothing in
     *     common
     */
    public CampaignComparison beside(List<CampaignRow> now) {
      Map<CampaignCase, CampaignRow> before = new TreeMap<>(CampaignCase.ORDER);
      for (CampaignRow row : rows) {
        if (!now.isEmpty() && row.id().values().size() == now.get(0).id().values().size()) {
          before.put(row.id(), row);
        }
      }
      CampaignComparison comparison = new CampaignComparison(before, now);
      if (!now.isEmpty() && comparison.added == now.size()) {
        throw refused(folder, "It has none of the cases of this campaign.");
      }
      return comparison;
    }
  }

  /**
   * Reads the cases of a campaign's results.
   *
   * @throws DiagnosticException (INPUT) {@code campaign.comparison} if there are none
   */
  public static Earlier read(Path folder) {
    try {
      byte[] bytes = Files.readAllBytes(folder.resolve(CampaignStore.CASES));
      return CampaignStore.read(bytes)
          .map(cases -> new Earlier(folder, cases.rows()))
          .orElseThrow(
              () -> refused(folder, "It is broken, or from another version of this program."));
    } catch (IOException e) {
      throw refused(folder, "There is no " + CampaignStore.CASES + " in it.");
    }
  }

  private static DiagnosticException refused(Path folder, String why) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(CampaignRules.COMPARISON, why, SourceLocation.of(folder))
            .withHint("Name the folder of a campaign's results, with its cases.json."));
  }

  /** Returns the cases that pass now, or no longer, in the order of their values. */
  List<Change> changes(boolean better) {
    return changes.stream().filter(each -> each.isBetter() == better).toList();
  }

  public String text() {
    return String.format(
        Locale.ROOT,
        "%d pass now, %d no longer pass, %d as before%s%n",
        changes(true).size(),
        changes(false).size(),
        same,
        added == 0 ? "" : ", " + Coverage.counted(added, "case") + " not in the other one");
  }
}
