package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;

/**
 * Objective that a search minimises: margins of criteria, each in units of how much those of its
 * criterion differ, since metres and seconds have no order.
 */
final class SearchObjective {

  /** Worse than what is judged: nothing is known of such a case. */
  static final double UNJUDGED = 1e6;

  /** Worse than all margins: the case passed, by no margin. */
  private static final double NO_MARGIN = 1e5;

  /** Better than all that passed. */
  private static final double FAILED = -1;

  private static final double BARELY_FAILED = -1e-9;

  /** Margins of one unit: of different units, a criterion may have several. */
  private record Kind(String criterion, String unit) {}

  private final Map<Kind, Double> spreads = new HashMap<>();
  private final Optional<String> only;
  private final List<String> nearest;

  /**
   * Creates an objective.
   *
   * @param results of cases from all over the space
   * @param only the beginning of the name of the criterion that is minimised; all without one
   */
  SearchObjective(Collection<CaseResult> results, Optional<String> only) {
    this.only = only;
    Map<Kind, List<Double>> margins = new HashMap<>();
    for (CaseResult result : results) {
      for (CriterionMargin each : result.criteria()) {
        if (each.label() != Label.UNTESTED && each.margin().isPresent() && counts(each)) {
          margins
              .computeIfAbsent(kind(each), key -> new ArrayList<>())
              .add(each.margin().getAsDouble());
        }
      }
    }
    margins.forEach((kind, values) -> spreads.put(kind, spread(values)));
    spreads.values().removeIf(spread -> spread <= 0);
    this.nearest = nearest(results);
  }

  private boolean counts(CriterionMargin each) {
    return only.isEmpty() || each.name().startsWith(only.get());
  }

  private static Kind kind(CriterionMargin each) {
    return new Kind(each.name(), each.unit());
  }

  /**
   * Returns the distance of the values between which the middle four fifths are; of all, where
   * these are the same.
   */
  private static double spread(List<Double> values) {
    List<Double> sorted = values.stream().sorted().toList();
    int last = sorted.size() - 1;
    int cut = sorted.size() / 10;
    double middle = sorted.get(last - cut) - sorted.get(cut);
    return middle > 0 ? middle : sorted.get(last) - sorted.get(0);
  }

  /** Returns whether there is nothing to go by: no margin, or the same one everywhere. */
  boolean isFlat() {
    return spreads.isEmpty();
  }

  /** Returns the names of the criteria that lead somewhere, the nearest to failing first. */
  List<String> criteria() {
    return nearest;
  }

  private List<String> nearest(Collection<CaseResult> results) {
    Map<String, Double> smallest = new TreeMap<>();
    spreads.keySet().forEach(kind -> smallest.put(kind.criterion(), UNJUDGED));
    for (CaseResult result : results) {
      smallest.replaceAll((name, value) -> Math.min(value, value(result, name)));
    }
    return smallest.entrySet().stream()
        .sorted(Map.Entry.comparingByValue())
        .map(Map.Entry::getKey)
        .toList();
  }

  /** Returns the smallest value of all criteria. */
  double value(CaseResult result) {
    return value(result, name -> true);
  }

  /** Returns the value of a case by one criterion: negative if it has failed. */
  double value(CaseResult result, String criterion) {
    return value(result, criterion::equals);
  }

  private double value(CaseResult result, Predicate<String> names) {
    if (result.label() == Label.ERROR || result.label() == Label.UNTESTED) {
      return UNJUDGED;
    }
    double least = NO_MARGIN;
    for (CriterionMargin each : result.criteria()) {
      if (counts(each) && each.label() != Label.UNTESTED && names.test(each.name())) {
        least = Math.min(least, value(each));
      }
    }
    return least;
  }

  private double value(CriterionMargin each) {
    Double spread = spreads.get(kind(each));
    boolean measured = spread != null && each.margin().isPresent();
    double margin = measured ? each.margin().getAsDouble() / spread : 0;
    if (each.label() == Label.FAILED) {
      return measured ? Math.min(margin, BARELY_FAILED) : FAILED;
    }
    return measured ? Math.max(margin, 0) : NO_MARGIN;
  }

  /** The smallest margin of a criterion, with its case. */
  record Smallest(CriterionMargin margin, CampaignRow row) {}

  /** Returns the smallest margin of each criterion, for each of its units, by their names. */
  static List<Smallest> smallest(Collection<CampaignRow> rows) {
    Map<String, Smallest> smallest = new TreeMap<>();
    for (CampaignRow row : rows) {
      for (CriterionMargin each : row.result().criteria()) {
        if (each.label() != Label.UNTESTED && each.margin().isPresent()) {
          smallest.merge(
              each.name() + "\n" + each.unit(),
              new Smallest(each, row),
              (one, other) ->
                  other.margin().margin().getAsDouble() < one.margin().margin().getAsDouble()
                      ? other
                      : one);
        }
      }
    }
    return List.copyOf(smallest.values());
  }
}
