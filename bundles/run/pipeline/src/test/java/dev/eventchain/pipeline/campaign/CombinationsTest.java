package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignReader;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.pipeline.campaign.plan.Shard;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what the parts of a campaign have. */
class CombinationsTest {

  @TempDir Path folder;

  private Combinations of(String more) throws Exception {
    Path file = folder.resolve("approach.yaml");
    Files.writeString(
        file,
        """
        scenario: stopped
        factors:
          gap: {path: "actors[0].gap_m", from: 10, to: 30, step: 10}
          speed: {path: ego.speed_kmh, values: [40, 50, 60, 70]}
        """
            + more);
    CampaignPlan plan = CampaignReader.read(file).get(0);
    return new Combinations(plan, new CaseList(plan).cases());
  }

  private static List<CampaignCase> ofAllParts(Combinations combinations, int count) {
    return IntStream.rangeClosed(1, count)
        .mapToObj(number -> combinations.of(new Shard(number, count)))
        .flatMap(List::stream)
        .sorted(CampaignCase.ORDER)
        .toList();
  }

  private static boolean isNear(CampaignCase each) {
    return each.values().get(0).intValue() == 20 && each.values().get(1).intValue() > 50;
  }

  @Test
  void eachCaseIsInOnePart() throws Exception {
    Combinations grid = of("");
    assertEquals(12, grid.count());
    for (int count : List.of(1, 2, 7, 12, 20)) {
      assertEquals(grid.of(Shard.ALL), ofAllParts(grid, count));
    }
    assertEquals(Set.of(7, 8), grid.parts(20, CombinationsTest::isNear));
    assertEquals(Set.of(1, 2), grid.parts(2, CombinationsTest::isNear));
    assertEquals(Set.of(), grid.parts(7, each -> false));
  }

  @Test
  void aBoundaryIsNotDivided() throws Exception {
    Combinations lines = of("boundary: {factor: gap, resolution: 1}\n");
    assertEquals(4, lines.count());
    List<CampaignCase> third = lines.of(new Shard(3, 4));
    assertEquals(
        List.of(10, 20, 30), third.stream().map(each -> each.values().get(0).intValue()).toList());
    assertEquals(lines.of(Shard.ALL), ofAllParts(lines, 3));
    assertEquals(Set.of(3, 4), lines.parts(4, CombinationsTest::isNear));
  }
}
