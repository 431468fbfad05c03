package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.pipeline.campaign.plan.Shard;
import dev.eventchain.pipeline.campaign.result.CampaignMerge;
import dev.eventchain.pipeline.campaign.result.CampaignStore;
import dev.eventchain.pipeline.results.ResultJson;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

/** Tests what is put together and what is refused. */
class CampaignMergeTest {

  private static final String HERE = "Python 3.11.7, Java 17, amd64, bubblewrap";
  private static final CampaignStore.Cases OWN = part("inputs", HERE, "1/1", true);

  @TempDir Path folder;

  private static CampaignStore.Cases part(
      String inputs, String platform, String shard, boolean complete) {
    return new CampaignStore.Cases(
        "approach", inputs, platform, Shard.parse(shard), complete, List.of());
  }

  private Path write(CampaignStore.Cases part) throws IOException {
    Path place = folder.resolve(part.shard().folder(part.campaign()));
    Files.createDirectories(place);
    Files.write(place.resolve("cases.json"), ResultJson.bytes(part));
    return place;
  }

  private static Diagnostic refusal(Executable action) {
    DiagnosticException e = assertThrows(DiagnosticException.class, action);
    assertEquals("campaign.merge", e.diagnostics().get(0).id());
    return e.diagnostics().get(0);
  }

  @Test
  void partsComeInTheirOrder() throws IOException {
    List<Path> folders =
        List.of(write(part("inputs", HERE, "2/2", true)), write(part("inputs", HERE, "1/2", true)));
    List<Shard> shards =
        CampaignMerge.parts(folders, "inputs").stream().map(CampaignStore.Cases::shard).toList();
    assertEquals(Stream.of("1/2", "2/2").map(Shard::parse).toList(), shards);
    assertEquals(List.of(), CampaignMerge.parts(List.of(), "inputs"));
  }

  @Test
  void partsOfDifferentVersionsAreNotMixed() throws IOException {
    String there = "Python 3.12.3, Java 17, amd64, bubblewrap";
    List<Path> folders =
        List.of(
            write(part("inputs", HERE, "1/2", true)), write(part("inputs", there, "2/2", true)));
    Diagnostic found = refusal(() -> CampaignMerge.parts(folders, "inputs"));
    assertTrue(found.message().endsWith("with " + there + ", but another one with " + HERE + "."));
    assertEquals(folders.get(1).toString(), found.location().file());
  }

  @Test
  void partsOfDifferentDivisionsAreNotMixed() throws IOException {
    List<Path> folders =
        List.of(write(part("inputs", HERE, "1/2", true)), write(part("inputs", HERE, "2/3", true)));
    Diagnostic found = refusal(() -> CampaignMerge.parts(folders, "inputs"));
    assertTrue(found.message().endsWith("is one of 3 parts, but another one is one of 2."));
  }

  @Test
  void whatANodeAnswersHasToFit() {
    Shard shard = Shard.parse("2/5");
    byte[] good = ResultJson.bytes(part("inputs", HERE, "2/5", true));
    assertEquals(shard, CampaignMerge.require(good, OWN, shard, "n1").shard());
    String other = "Python 3.11.9, Java 21, amd64, audit-hooks";
    Diagnostic found = refusal("inputs", other, "2/5", true);
    assertEquals(
        "approach-2-of-5 was simulated with %s on the node n1, but this machine has %s."
            .formatted(other, HERE),
        found.message());
    assertTrue(found.hint().contains("EVENTCHAIN_PYTHON"));
    assertTrue(refusal("others", HERE, "2/5", true).message().contains("is of another state"));
    assertTrue(refusal("inputs", HERE, "3/5", true).message().contains("is another part"));
    assertTrue(refusal("inputs", HERE, "2/5", false).message().contains("is broken"));
    byte[] broken = "{".getBytes(StandardCharsets.UTF_8);
    refusal(() -> CampaignMerge.require(broken, OWN, shard, "n1"));
  }

  private static Diagnostic refusal(
      String inputs, String platform, String shard, boolean complete) {
    byte[] bytes = ResultJson.bytes(part(inputs, platform, shard, complete));
    return refusal(() -> CampaignMerge.require(bytes, OWN, Shard.parse("2/5"), "n1"));
  }
}
