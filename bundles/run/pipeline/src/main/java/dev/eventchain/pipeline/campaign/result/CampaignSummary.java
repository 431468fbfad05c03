package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Trial;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Results of the cases of a campaign, as findings and as text. */
public final class CampaignSummary {

  private final CampaignPlan plan;
  private final List<CampaignRow> rows;
  private final Map<CampaignCase, Diagnostic> wrong;

  public CampaignSummary(CampaignPlan plan, List<CampaignRow> rows) {
    this(plan, rows, Map.of());
  }

  /**
   * Creates the results of cases.
   *
   * @param wrong what is wrong with the criteria of cases that ended by an error because of that
   */
  public CampaignSummary(
      CampaignPlan plan, List<CampaignRow> rows, Map<CampaignCase, Diagnostic> wrong) {
    this.plan = plan;
    this.rows = rows;
    this.wrong = wrong;
  }

  long count(Label label) {
    return rows.stream().filter(row -> row.is(label)).count();
  }

  /**
   * Returns a finding for each kind of case that did not pass, with its first case. Where a
   * boundary is searched, cases are to fail on one side of it.
   */
  public List<Diagnostic> findings(SourceLocation place) {
    return findings(place, plan.boundary().isEmpty() || count(Label.PASSED) == 0);
  }

  /** As {@link #findings(SourceLocation)}, with or without one for the cases that failed. */
  public List<Diagnostic> findings(SourceLocation place, boolean withFailed) {
    List<Diagnostic> found = new ArrayList<>(new LinkedHashSet<>(wrong.values()));
    add(found, Label.ERROR, "ended by an error", CampaignRules.CASE_ERROR, place);
    if (withFailed) {
      add(found, Label.FAILED, "failed", CampaignRules.CASE_FAILED, place);
    }
    add(found, Label.UNTESTED, "not tested", CampaignRules.CASE_UNTESTED, place);
    for (String criterion : untested()) {
      found.add(
          Diagnostic.of(
              CampaignRules.CRITERION_UNTESTED,
              "In none of %s, '%s' was tested."
                  .formatted(Coverage.counted(rows.size(), "case"), criterion),
              place));
    }
    return found;
  }

  /** Returns the criteria that were judged in no case. */
  private Set<String> untested() {
    Set<String> untested = new LinkedHashSet<>();
    Set<String> tested = new HashSet<>();
    for (CampaignRow row : rows) {
      for (CriterionMargin each : row.result().criteria()) {
        (each.label() == Label.UNTESTED ? untested : tested).add(each.name());
      }
    }
    untested.removeAll(tested);
    return untested;
  }

  private void add(
      List<Diagnostic> found, Label label, String word, Rule rule, SourceLocation place) {
    List<CampaignRow> all =
        rows.stream().filter(row -> row.is(label) && !wrong.containsKey(row.id())).toList();
    if (!all.isEmpty()) {
      found.add(Diagnostic.of(rule, said(all, word), place));
    }
  }

  private String said(List<CampaignRow> all, String word) {
    CampaignRow row = all.get(0);
    int number = rows.indexOf(row) + 1;
    return String.format(
        Locale.ROOT,
        "%d of %s %s, the first is case %d (%s): %s.",
        all.size(),
        Coverage.counted(rows.size(), "case"),
        word,
        number,
        row.id().words(plan),
        row.result().reason().replaceFirst("\\.$", ""));
  }

  /**
   * Returns a test for each case, which failed if it did not pass; where a boundary is searched,
   * for each combination of the other factors, since cases are to fail there.
   */
  public List<Trial> trials() {
    return plan.boundary()
        .map(it -> new BoundaryTrials(plan, it, rows).of(new BoundarySearch(it).lines(rows)))
        .orElseGet(this::trialsOfCases);
  }

  private List<Trial> trialsOfCases() {
    List<Trial> trials = new ArrayList<>();
    Optional<CampaignPoints> points = CampaignPoints.of(plan, rows);
    for (int i = 0; i < rows.size(); i++) {
      CampaignRow row = rows.get(i);
      int index = i;
      Trial.Outcome outcome = row.is(Label.PASSED) ? Trial.Outcome.PASSED : Trial.Outcome.FAILED;
      String name = plan.name() + ": " + row.id().words(plan);
      CaseResult result = row.result();
      String text =
          Stream.of(row.reason(), points.map(it -> it.words(index)).orElse(""))
              .filter(words -> !words.isEmpty())
              .collect(Collectors.joining("; "));
      Map<String, String> figures = points.map(it -> it.figures(index)).orElse(Map.of());
      trials.add(
          new Trial(Trial.Kind.CASE, name, outcome, text, result.end(), List.of())
              .withFigures(figures));
    }
    return trials;
  }

  /** Returns what is easily misread about the cases that passed; empty if nothing is. */
  String ofNothingAhead() {
    long count = rows.stream().filter(row -> row.result().nothingAhead()).count();
    return count == 0
        ? ""
        : String.format(
            Locale.ROOT,
            "%d of the passed had nothing ahead: there is no impact then, which may say nothing about"
                + " the software",
            count);
  }

  /** Returns what is said about the boundary, if one is searched. */
  private static String text(BoundaryWords words) {
    return Stream.of(words.flips(), words.rest())
        .filter(line -> !line.isEmpty())
        .map(line -> line + "\n")
        .collect(Collectors.joining());
  }

  /** Returns the boundary, if one is searched. */
  Optional<BoundaryWords> boundary() {
    return plan.boundary()
        .map(it -> new BoundaryWords(plan, it, new BoundarySearch(it).lines(rows)));
  }

  /** A case that passed, with the margin of one of its criteria. */
  record Near(CampaignRow row, CriterionMargin margin) {}

  /**
   * Returns the passed cases with the smallest margins of each criterion: margins of different
   * criteria have no order.
   *
   * @param most of one criterion
   */
  List<Near> nearest(int most) {
    Map<String, List<Near>> byCriterion = new LinkedHashMap<>();
    for (CampaignRow row : rows) {
      for (CriterionMargin each : row.result().criteria()) {
        if (row.is(Label.PASSED) && each.margin().isPresent()) {
          byCriterion
              .computeIfAbsent(each.name() + "\n" + each.unit(), key -> new ArrayList<>())
              .add(new Near(row, each));
        }
      }
    }
    return byCriterion.values().stream()
        .flatMap(
            near ->
                near.stream()
                    .sorted(Comparator.comparingDouble(it -> it.margin().margin().getAsDouble()))
                    .limit(most))
        .toList();
  }

  public String text() {
    StringBuilder text =
        new StringBuilder(
            String.format(
                Locale.ROOT,
                "%s: %d passed, %d failed, %d not tested, %d ended by an error%n",
                Coverage.counted(rows.size(), "case"),
                count(Label.PASSED),
                count(Label.FAILED),
                count(Label.UNTESTED),
                count(Label.ERROR)));
    text.append(ofNothingAhead().isEmpty() ? "" : ofNothingAhead() + "\n");
    boundary().ifPresent(it -> text.append(text(it)));
    Optional<CampaignPoints> points = CampaignPoints.of(plan, rows);
    points.ifPresent(it -> text.append("points: %s (%s)%n".formatted(it.total(), it.note())));
    return text.append(CampaignMatrix.of(plan, rows, points)).toString();
  }
}
