package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** Statements about the boundary of a campaign: what was found, and what was not. */
final class BoundaryWords {

  private final CampaignPlan plan;
  private final CampaignPlan.Boundary boundary;
  private final List<BoundarySearch.Line> lines;

  BoundaryWords(
      CampaignPlan plan, CampaignPlan.Boundary boundary, List<BoundarySearch.Line> lines) {
    this.plan = plan;
    this.boundary = boundary;
    this.lines = lines;
  }

  /** Returns the number of flips, and those that are wider than the resolution. */
  String flips() {
    List<BoundarySearch.Flip> flips = all();
    long wide = flips.stream().filter(flip -> !flip.isNarrow()).count();
    String found = Coverage.counted(flips.size(), "flip") + of() + " along " + factor();
    String size = flips.isEmpty() ? "" : ", to within " + boundary.resolution().toPlainString();
    String wider =
        wide == 0 ? "" : ", except for " + wide + ", where no case between has a verdict";
    return found + size + wider;
  }

  /** Returns the flips, in the order of the other factors, and then of this one. */
  List<BoundarySearch.Flip> all() {
    return lines.stream().flatMap(line -> line.flips().stream()).toList();
  }

  private String of() {
    return boundary.criterion().map(it -> " of '" + it.text() + "'").orElse("");
  }

  String factor() {
    return plan.names().get(boundary.factor());
  }

  /** Returns the combinations of the other factors without a flip. */
  List<BoundarySearch.Line> quiet() {
    return lines.stream().filter(line -> line.flips().isEmpty()).toList();
  }

  /** Returns what is the same throughout in how many combinations; empty if all have a flip. */
  String rest() {
    List<BoundarySearch.Line> quiet = quiet();
    if (quiet.isEmpty()) {
      return "";
    }
    List<String> parts = new ArrayList<>();
    Stream.of(Label.PASSED, Label.FAILED, Label.UNTESTED)
        .forEach(
            label -> {
              long count = quiet.stream().filter(line -> isThroughout(line, label)).count();
              if (count > 0) {
                parts.add(count + " " + CampaignRow.words(label) + " throughout");
              }
            });
    long few = quiet.stream().filter(line -> line.sides().size() < 2).count();
    if (few > 0) {
      parts.add(few + " with fewer than two verdicts");
    }
    return String.format(
        Locale.ROOT,
        "no flip between the values of %s in %d of %s of the others: %s",
        factor(),
        quiet.size(),
        Coverage.counted(lines.size(), "combination"),
        String.join(", ", parts));
  }

  private static boolean isThroughout(BoundarySearch.Line line, Label label) {
    return line.sides().size() > 1 && line.sides().get(0).label() == label;
  }

  /** Returns the verdict of all cases of a combination without a flip. */
  static String throughout(BoundarySearch.Line line) {
    return line.sides().size() > 1
        ? CampaignRow.words(line.sides().get(0).label()) + " throughout"
        : "fewer than two verdicts";
  }
}
