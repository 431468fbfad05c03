package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.pipeline.campaign.plan.Conditions;
import dev.eventchain.pipeline.campaign.plan.Factor;
import dev.eventchain.pipeline.campaign.plan.Levels;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;

/** The factors of a campaign as a unit cube: a coordinate is the share of a factor's values. */
final class SearchSpace {

  private static final int TRIED = 256;

  /** Factors with few corners. */
  private static final int FEW = 8;

  private final CampaignPlan plan;
  private final Conditions conditions;

  /**
   * Creates a space.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException (INPUT) if a condition cannot be read
   */
  SearchSpace(CampaignPlan plan) {
    this.plan = plan;
    this.conditions = new Conditions(plan, plan.conditions());
  }

  int dimensions() {
    return plan.factors().size();
  }

  Levels levels(int factor) {
    return plan.factors().get(factor).levels();
  }

  /**
   * Returns cases from all over the space, its corners among them if they are few: those that the
   * conditions keep, or all if they keep none.
   */
  List<CampaignCase> tried() {
    List<double[]> points = new ArrayList<>(spread(TRIED, new SplittableRandom(plan.seed())));
    if (dimensions() <= FEW) {
      points.addAll(corners());
    }
    List<CampaignCase> all = points.stream().map(this::at).distinct().toList();
    List<CampaignCase> kept = all.stream().filter(this::keeps).toList();
    return kept.isEmpty() ? all : kept;
  }

  private List<double[]> corners() {
    List<double[]> corners = new ArrayList<>();
    for (int corner = 0; corner < 1 << dimensions(); corner++) {
      double[] point = new double[dimensions()];
      for (int i = 0; i < point.length; i++) {
        point[i] = (corner >> i & 1) == 0 ? 0.0 : Math.nextDown(1.0);
      }
      corners.add(point);
    }
    return corners;
  }

  /** Returns the case at a point. */
  CampaignCase at(double[] point) {
    List<BigDecimal> values = new ArrayList<>();
    for (int i = 0; i < point.length; i++) {
      values.add(levels(i).at(point[i]));
    }
    return new CampaignCase(values, 1);
  }

  /** Returns whether the conditions keep a case; they hold their values while they are judged. */
  synchronized boolean keeps(CampaignCase each) {
    return conditions.keep(each);
  }

  /** Returns whether a factor may have a value: one of its own, or one between its bounds. */
  boolean spans(int factor, BigDecimal value) {
    List<BigDecimal> values = levels(factor).checked();
    if (!levels(factor).isContinuous()) {
      return values.stream().anyMatch(each -> each.compareTo(value) == 0);
    }
    return Collections.min(values).compareTo(value) <= 0
        && Collections.max(values).compareTo(value) >= 0;
  }

  /** Returns points that fill the range of each factor evenly. */
  List<double[]> spread(int points, SplittableRandom random) {
    List<double[]> spread = new ArrayList<>();
    for (int k = 0; k < points; k++) {
      spread.add(new double[dimensions()]);
    }
    for (int i = 0; i < dimensions(); i++) {
      double[] shares = CaseList.strata(points, random);
      for (int k = 0; k < points; k++) {
        spread.get(k)[i] = shares[k];
      }
    }
    return spread;
  }

  private static String plain(BigDecimal value) {
    return value.stripTrailingZeros().toPlainString();
  }

  /**
   * Returns what is searched, in words: {@code speed from 30 to 60, gap from 10 to 50 (5 values)}.
   */
  String words() {
    List<String> words = new ArrayList<>();
    for (Factor factor : plan.factors()) {
      List<BigDecimal> values = factor.levels().checked();
      String ends =
          "from %s to %s".formatted(plain(Collections.min(values)), plain(Collections.max(values)));
      boolean drawn = factor.levels().isContinuous();
      words.add(factor.name() + " " + ends + (drawn ? "" : " (" + values.size() + " values)"));
    }
    return String.join(", ", words);
  }
}
