package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.Computed;
import dev.eventchain.pipeline.campaign.plan.Factor;
import dev.eventchain.pipeline.campaign.plan.Points;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Pattern;

/** Criteria on which points depend, among those of the cases for which points are counted. */
final class CriteriaOfPoints {

  /** A number of its own, and not of a name such as {@code AEB-3} or {@code car2}. */
  private static final Pattern NUMBER = Pattern.compile("(?<![\\w-])-?[0-9][0-9.eE+-]*");

  private final CampaignPlan plan;
  private final Points points;
  private final Function<CampaignCase, List<String>> texts;

  /**
   * Creates a check.
   *
   * @param texts returns those of the criteria of a case; none if it cannot be read
   */
  CriteriaOfPoints(CampaignPlan plan, Points points, Function<CampaignCase, List<String>> texts) {
    this.plan = plan;
    this.points = points;
    this.texts = texts;
  }

  /**
   * Returns the problems of the named criteria. A name must be the beginning of a criterion in some
   * case, and in each case that has the criterion; otherwise the case would count as kept. The
   * protocol must have some of the cases.
   *
   * @param kinds the cases by the criteria that they have
   */
  List<Diagnostic> check(Collection<List<CampaignCase>> kinds) {
    List<List<CampaignCase>> counted =
        kinds.stream()
            .map(kind -> kind.stream().filter(plan::counts).toList())
            .filter(kind -> !kind.isEmpty())
            .toList();
    if (counted.isEmpty()) {
      String message = "No case of '" + plan.name() + "' is one of the protocol.";
      return List.of(
          CriteriaOfCases.finding(message, points.place())
              .withHint("Loosen a condition under 'where' of 'points', or leave 'points' out."));
    }
    if (points.criteria().isEmpty()) {
      return List.of();
    }
    List<List<List<String>>> all = counted.stream().map(this::texts).toList();
    List<Diagnostic> found =
        points.criteria().stream().flatMap(named -> problem(named, all).stream()).toList();
    return found.isEmpty() ? likeNamed(counted).stream().toList() : found;
  }

  /** Returns a finding for the first case that lacks a criterion that is named. */
  private Optional<Diagnostic> likeNamed(List<List<CampaignCase>> counted) {
    return counted.stream()
        .map(kind -> kind.get(0))
        .flatMap(first -> lacking(first, texts.apply(first)).stream())
        .findFirst();
  }

  /**
   * Requires that a case has the named criteria if it has criteria that differ from them in numbers
   * only; otherwise it would count as kept. Only some of all limits are tried before the first
   * case.
   *
   * @param texts those of its criteria
   * @throws DiagnosticException (INPUT) if it has others
   */
  void require(CampaignCase each, List<String> texts) {
    if (!points.criteria().isEmpty() && plan.counts(each)) {
      lacking(each, texts)
          .ifPresent(
              found -> {
                throw new DiagnosticException(DiagnosticException.Reason.INPUT, found);
              });
    }
  }

  private Optional<Diagnostic> lacking(CampaignCase each, List<String> texts) {
    List<String> others =
        texts.stream()
            .filter(text -> points.criteria().stream().noneMatch(text::startsWith))
            .toList();
    for (String named : points.criteria()) {
      Optional<String> like =
          isIn(texts, named)
              ? Optional.empty()
              : others.stream()
                  .filter(text -> withoutNumbers(text).startsWith(withoutNumbers(named)))
                  .findFirst();
      if (like.isPresent()) {
        String message = "With %s, the criterion is '%s', which does not begin with '%s'.";
        return Optional.of(
            CriteriaOfCases.finding(
                    message.formatted(each.words(plan), like.get(), named), points.place())
                .withHint("Name only what comes before the number."));
      }
    }
    return Optional.empty();
  }

  private static String withoutNumbers(String text) {
    return NUMBER.matcher(text).replaceAll("0");
  }

  /**
   * Returns the texts in cases of a kind that differ in numbers of criteria, or in some of them.
   */
  private List<List<String>> texts(List<CampaignCase> kind) {
    Map<Map<String, BigDecimal>, CampaignCase> different = new LinkedHashMap<>();
    for (CampaignCase each : kind) {
      Map<String, BigDecimal> limits = plan.settings(each);
      limits.keySet().removeIf(path -> !CriteriaOfCases.isPath(path));
      different.putIfAbsent(limits, each);
    }
    return RefusedValues.some(List.copyOf(different.values())).stream()
        .map(texts)
        .filter(read -> !read.isEmpty())
        .toList();
  }

  private Optional<Diagnostic> problem(String named, List<List<List<String>>> kinds) {
    boolean isKnown = false;
    for (List<List<String>> kind : kinds) {
      List<Boolean> matches = kind.stream().map(all -> isIn(all, named)).distinct().toList();
      if (matches.size() > 1) {
        String message = "The text that begins with '%s' changes with %s.";
        return Optional.of(
            CriteriaOfCases.finding(message.formatted(named, changing()), points.place())
                .withHint("Name only what comes before the number."));
      }
      isKnown |= matches.contains(true);
    }
    List<String> all = kinds.stream().flatMap(List::stream).flatMap(List::stream).toList();
    return isKnown || all.isEmpty()
        ? Optional.empty()
        : Optional.of(
            CriteriaOfCases.finding(
                    "No criterion of the cases begins with '" + named + "'.", points.place())
                .withHint(NearestName.hint(named, all.stream().distinct().toList())));
  }

  private static boolean isIn(List<String> texts, String named) {
    return texts.stream().anyMatch(text -> text.startsWith(named));
  }

  /** Returns the factors, and what is computed, whose numbers are in criteria. */
  private String changing() {
    Map<String, List<String>> paths = new LinkedHashMap<>();
    for (Factor factor : plan.factors()) {
      paths.put(factor.name(), factor.paths());
    }
    for (Computed computed : plan.computed()) {
      paths.put(computed.name(), computed.paths());
    }
    List<String> names = new ArrayList<>();
    paths.forEach(
        (name, all) -> {
          if (all.stream().anyMatch(CriteriaOfCases::isPath)) {
            names.add("'" + name + "'");
          }
        });
    return String.join(" and ", names);
  }
}
