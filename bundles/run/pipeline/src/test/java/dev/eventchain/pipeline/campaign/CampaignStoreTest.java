package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.Shard;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.pipeline.campaign.result.CampaignStore;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what of a campaign's results is kept, and taken again. */
class CampaignStoreTest {

  @TempDir Path results;

  private CampaignStore open(String inputs) {
    return new CampaignStore(
        results,
        new CampaignStore.Cases("a", inputs, "Python", Shard.ALL, false, List.of()),
        () -> true);
  }

  private static CampaignRow row(int value) {
    return new CampaignRow(
        new CampaignCase(List.of(BigDecimal.valueOf(value)), 1),
        new CaseResult(Label.PASSED, "", List.of(), OptionalDouble.empty(), 1));
  }

  private int known(String inputs) {
    try (CampaignStore store = open(inputs)) {
      return store.rows().size();
    }
  }

  /** As on a disk that is full for a while, after which the campaign is killed. */
  @Test
  void whatCouldNotBeKeptAtOnceIsKeptLater() throws IOException {
    Path first = results.resolve("a/parts/000001.json");
    try (CampaignStore store = open("x")) {
      store.add(row(1));
      Files.createDirectories(first);
      assertThrows(DiagnosticException.class, store::save);
      Files.delete(first);
      store.add(row(2));
      store.save();
    }
    assertEquals(2, known("x"));
    assertEquals(0, known("y"));
  }

  @Test
  void whatSomebodyElseHasChangedIsNotTaken() throws IOException {
    try (CampaignStore store = open("x")) {
      store.add(row(1));
      store.save();
      store.add(row(2));
      store.complete();
    }
    assertEquals(2, known("x"));
    Path cases = results.resolve("a/cases.json");
    Files.writeString(cases, Files.readString(cases).replaceFirst("PASSED", "FAILED"));
    assertEquals(0, known("x"));
  }
}
