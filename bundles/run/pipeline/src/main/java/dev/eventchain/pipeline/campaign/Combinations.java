package dev.eventchain.pipeline.campaign;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.Shard;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Predicate;

/**
 * The cases of a campaign, together where they have to be simulated together: along a boundary, all
 * with the same values of the other factors.
 */
final class Combinations {

  private final List<List<CampaignCase>> all;

  Combinations(CampaignPlan plan, List<CampaignCase> cases) {
    Map<CampaignCase, List<CampaignCase>> known = new LinkedHashMap<>();
    for (CampaignCase each : cases) {
      CampaignCase whole =
          plan.boundary().map(it -> each.with(it.factor(), BigDecimal.ZERO)).orElse(each);
      known.computeIfAbsent(whole, it -> new ArrayList<>()).add(each);
    }
    all = List.copyOf(known.values());
  }

  /** Returns the numbers of those parts that have a wanted case. */
  SortedSet<Integer> parts(int count, Predicate<CampaignCase> wanted) {
    SortedSet<Integer> parts = new TreeSet<>();
    for (int index = 0; index < all.size(); index++) {
      if (all.get(index).stream().anyMatch(wanted)) {
        parts.add(Shard.numberOf(index, count));
      }
    }
    return parts;
  }

  int count() {
    return all.size();
  }

  /** Returns the cases of a part, in the order of their values. */
  List<CampaignCase> of(Shard shard) {
    List<CampaignCase> own = new ArrayList<>();
    for (int index = 0; index < all.size(); index++) {
      if (shard.has(index)) {
        own.addAll(all.get(index));
      }
    }
    own.sort(CampaignCase.ORDER);
    return own;
  }
}
