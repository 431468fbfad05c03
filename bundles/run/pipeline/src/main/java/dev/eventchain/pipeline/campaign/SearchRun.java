package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * A case that a search asked for.
 *
 * @param seed the number of the independent search, from 1; 0 for those that are spread at first
 * @param order from 1, among those of the same seed
 * @param point of the unit cube
 */
record SearchRun(int seed, int order, List<Double> point, CampaignRow row) {

  boolean isFailed() {
    return row.is(Label.FAILED);
  }

  /** Returns the names of the criteria that failed. */
  static Set<String> failed(CaseResult result) {
    Set<String> failed = new TreeSet<>();
    for (CaseResult.CriterionMargin each : result.criteria()) {
      if (each.label() == Label.FAILED) {
        failed.add(each.name());
      }
    }
    return failed;
  }

  double distance(SearchRun other) {
    double sum = 0;
    for (int i = 0; i < point.size(); i++) {
      double difference = point.get(i) - other.point.get(i);
      sum += difference * difference;
    }
    return Math.sqrt(sum);
  }

  /** Returns the point at a share of the way to another one. */
  double[] towards(SearchRun other, double share) {
    double[] between = new double[point.size()];
    for (int i = 0; i < between.length; i++) {
      between[i] = point.get(i) + share * (other.point.get(i) - point.get(i));
    }
    return between;
  }
}
