package dev.eventchain.pipeline.campaign.plan;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;

/**
 * A case of a campaign.
 *
 * @param values of the factors, in their order
 * @param repetition from 1
 */
public record CampaignCase(List<BigDecimal> values, int repetition) {

  /** By values, then by repetition. */
  public static final Comparator<CampaignCase> ORDER =
      (one, other) -> {
        for (int i = 0; i < one.values.size(); i++) {
          int order = one.values.get(i).compareTo(other.values.get(i));
          if (order != 0) {
            return order;
          }
        }
        return Integer.compare(one.repetition, other.repetition);
      };

  public CampaignCase {
    values = values.stream().map(CampaignCase::plain).toList();
  }

  /** Returns equal numbers as equal values: 1.50 as 1.5, and 100 not as 1E+2. */
  private static BigDecimal plain(BigDecimal value) {
    return new BigDecimal(value.stripTrailingZeros().toPlainString());
  }

  /** Returns this case with another value. */
  public CampaignCase with(int factor, BigDecimal value) {
    List<BigDecimal> others = new ArrayList<>(values);
    others.set(factor, value);
    return new CampaignCase(others, repetition);
  }

  /** Returns it in words: {@code speed = 50, gap = 20}. */
  public String words(CampaignPlan plan) {
    return wordsWithout(-1, plan);
  }

  /** Returns it in words, without the value of a factor. */
  public String wordsWithout(int factor, CampaignPlan plan) {
    List<String> words = new ArrayList<>();
    for (int i = 0; i < values.size(); i++) {
      if (i == factor) {
        continue;
      }
      words.add(plan.factors().get(i).name() + " = " + values.get(i).toPlainString());
    }
    if (plan.repetitions() > 1) {
      words.add("repetition " + repetition);
    }
    return words.stream().collect(Collectors.joining(", "));
  }
}
