package dev.eventchain.pipeline.campaign.plan;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;

/**
 * Combinations in which any two values of two factors occur together. Each one is begun with the
 * first open pair, and takes for each other factor the value that closes most open pairs (the
 * greedy method of AETG, without its random choices). A pair whose combination is not kept is left
 * out.
 */
final class PairsOfValues {

  /** Two values: the numbers of their factors, and their own. */
  private record Pair(int factor, int value, int otherFactor, int otherValue) {}

  private final List<List<BigDecimal>> levels;
  private final Predicate<List<BigDecimal>> keep;
  private final Set<Pair> open = new LinkedHashSet<>();

  PairsOfValues(CampaignPlan plan, Predicate<List<BigDecimal>> keep) {
    this.levels = plan.factors().stream().map(factor -> factor.levels().checked()).toList();
    this.keep = keep;
    for (int a = 0; a < levels.size(); a++) {
      for (int b = a + 1; b < levels.size(); b++) {
        for (int i = 0; i < levels.get(a).size(); i++) {
          for (int j = 0; j < levels.get(b).size(); j++) {
            open.add(new Pair(a, i, b, j));
          }
        }
      }
    }
  }

  Set<List<BigDecimal>> cover() {
    Set<List<BigDecimal>> combinations = new LinkedHashSet<>();
    if (levels.size() == 1) {
      levels.get(0).stream().map(List::of).filter(keep).forEach(combinations::add);
    }
    while (!open.isEmpty()) {
      Pair first = open.iterator().next();
      int[] chosen = begunWith(first);
      if (!keep.test(values(chosen)) && !search(chosen, first, 0)) {
        open.remove(first);
        continue;
      }
      combinations.add(values(chosen));
      open.removeIf(pair -> closes(pair, chosen));
    }
    return combinations;
  }

  private List<BigDecimal> values(int[] chosen) {
    List<BigDecimal> values = new ArrayList<>();
    for (int i = 0; i < chosen.length; i++) {
      values.add(levels.get(i).get(chosen[i]));
    }
    return values;
  }

  /** Looks for values of the other factors with which a pair is kept, in their order. */
  private boolean search(int[] chosen, Pair first, int factor) {
    if (factor == chosen.length) {
      return keep.test(values(chosen));
    }
    if (factor == first.factor() || factor == first.otherFactor()) {
      return search(chosen, first, factor + 1);
    }
    for (int value = 0; value < levels.get(factor).size(); value++) {
      chosen[factor] = value;
      if (search(chosen, first, factor + 1)) {
        return true;
      }
    }
    return false;
  }

  private static boolean closes(Pair pair, int[] chosen) {
    return chosen[pair.factor()] == pair.value() && chosen[pair.otherFactor()] == pair.otherValue();
  }

  private int[] begunWith(Pair first) {
    int[] chosen = new int[levels.size()];
    Arrays.fill(chosen, -1);
    chosen[first.factor()] = first.value();
    chosen[first.otherFactor()] = first.otherValue();
    for (int factor = 0; factor < chosen.length; factor++) {
      if (chosen[factor] < 0) {
        chosen[factor] = best(chosen, factor);
      }
    }
    return chosen;
  }

  private int best(int[] chosen, int factor) {
    int best = 0;
    long most = -1;
    for (int value = 0; value < levels.get(factor).size(); value++) {
      chosen[factor] = value;
      long closed = open.stream().filter(pair -> closes(pair, chosen)).count();
      if (closed > most) {
        most = closed;
        best = value;
      }
    }
    chosen[factor] = -1;
    return best;
  }
}
