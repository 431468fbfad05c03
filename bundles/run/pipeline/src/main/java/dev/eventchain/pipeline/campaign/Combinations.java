package dev.eventchain.pipeline.campaign;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

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
