package dev.eventchain.pipeline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.pipeline.campaign.Campaigns;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests what is wrong with campaign files. */
class CampaignReaderTest {

  private static final Path INVALID =
      Path.of("src/test/resources/dev/eventchain/pipeline/campaign/invalid");
  private static final String EXPECT = "# expect: ";

  /** Keys of files of another kind. */
  private static final Set<String> OTHERS = Set.of("campaigns", "accept");

  @TempDir Path folder;

  static Stream<Path> files() throws IOException {
    try (Stream<Path> files = Files.list(INVALID)) {
      return files.filter(file -> file.toString().endsWith(".yaml")).sorted().toList().stream();
    }
  }

  /** The first lines of each file list its findings: id, line and column. */
  @ParameterizedTest
  @MethodSource("files")
  void everyProblemOfAFileIsFoundAtItsPlace(Path file) throws IOException {
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> CampaignReader.read(file));
    List<String> expected =
        Files.readAllLines(file).stream()
            .filter(line -> line.startsWith(EXPECT))
            .map(line -> line.substring(EXPECT.length()))
            .toList();
    assertEquals(
        expected,
        refused.diagnostics().stream()
            .map(each -> each.id() + " " + each.location().line() + ":" + each.location().column())
            .toList(),
        refused::getMessage);
  }

  @Test
  void theSchemaKnowsAllKeys() throws IOException {
    JsonNode schema = new ObjectMapper().readTree(Campaigns.schema());
    Set<String> kinds = new TreeSet<>();
    schema.at("/properties/sampling/properties").fieldNames().forEachRemaining(kinds::add);
    Set<String> known = new TreeSet<>();
    for (Sampling.Kind kind : Sampling.Kind.values()) {
      known.add(kind.key());
    }
    assertEquals(known, kinds);
    StringBuilder all = new StringBuilder("scenario: s\ndescription: d\n");
    all.append("factors: {f: {path: p, paths: [q], from: 1, to: 2, step: 1}}\n");
    all.append("computed: {g: {path: r, paths: [t], formula: 2 * f}}\n");
    all.append("sampling: {grid: true}\nwhere: [f > 0]\nrepetitions: 2\nseed: 3\n");
    all.append("boundary: {factor: f, resolution: 1}\n");
    all.append("tags: [t]\ncriteria: [{where: [f > 0], accept: {no_impact: true}}]\n");
    all.append("points: {source: p, most: 2 * f, at_impact: if impact < g then 0.5 else 0,\n");
    all.append("  criteria: [no impact], where: [f > 1]}\n");
    all.append("search: {criterion: c, method: random, runs: 20, seeds: 2, stop: first_failure}\n");
    CampaignPlan plan =
        CampaignReader.read(Files.writeString(folder.resolve("a.yaml"), all)).get(0);
    assertEquals(List.of("q", "p"), plan.factors().get(0).paths());
    assertEquals(20, plan.search().runs());
    assertTrue(plan.search().stopsAtFirst());
    for (String part : List.of("search", "points")) {
      schema
          .at("/properties/" + part + "/properties")
          .fieldNames()
          .forEachRemaining(key -> assertTrue(all.toString().contains(key + ":"), key));
    }
    schema
        .path("properties")
        .fieldNames()
        .forEachRemaining(
            key -> assertTrue(OTHERS.contains(key) || all.toString().contains(key + ":"), key));
  }

  @Test
  void aFileOfSeveralCampaignsHasThemInItsOrder() throws IOException {
    String text =
        """
        description: near and far
        campaigns:
          near: {scenario: s, factors: {f: {path: p, values: [1]}}}
          far: {scenario: t, factors: {f: {path: p, values: [1]}}, seed: 3}
        """;
    List<CampaignPlan> plans =
        CampaignReader.read(Files.writeString(folder.resolve("both.yaml"), text));
    assertEquals(
        List.of("both-near s 1", "both-far t 3"),
        plans.stream().map(it -> it.name() + " " + it.scenario() + " " + it.seed()).toList());
  }

  /** By tags, all of which a campaign needs, and for some of its own cases. */
  @Test
  void criteriaAreThoseOfTheTagsOfACampaign() throws IOException {
    String text =
        """
        criteria:
          - {tags: [rear-end], accept: {no_impact: true}}
          - {tags: [rear-end, RoadTypeMotorway], accept: {minimal_gap_m: 1}}
        campaigns:
          near:
            tags: [rear-end]
            scenario: s
            factors: {f: {path: p, values: [1]}}
            criteria: [{where: [f > 0], accept: {stops: true}}]
          far: {tags: [RoadTypeMotorway, rear-end], scenario: t, factors: {f: {path: p, values: [1]}}}
          other: {scenario: u, factors: {f: {path: p, values: [1]}}}
        """;
    List<CampaignPlan> plans =
        CampaignReader.read(Files.writeString(folder.resolve("tags.yaml"), text));
    assertEquals(
        List.of(
            List.of("{\"no_impact\":true}", "{\"stops\":true}"),
            List.of("{\"no_impact\":true}", "{\"minimal_gap_m\":1}"),
            List.of()),
        plans.stream()
            .map(plan -> plan.criteria().stream().map(it -> it.accept().toString()).toList())
            .toList());
  }

  @Test
  void aTableThatIsNotThereIsFoundAtItsFactor() throws IOException {
    Path file = folder.resolve("a.yaml");
    Files.writeString(file, "scenario: s\nfactors: {f: {path: p, csv: no.csv, column: c}}\n");
    Diagnostic found =
        assertThrows(DiagnosticException.class, () -> CampaignReader.read(file))
            .diagnostics()
            .get(0);
    assertEquals("There is no file 'no.csv'.", found.message());
    assertEquals("/factors/f/csv", found.location().element());
  }

  /** A search goes between bounds by itself, and a grid has no end of values there. */
  @Test
  void onlyASearchNeedsNoSamplingOfBounds() throws IOException {
    Path file = folder.resolve("a.yaml");
    Files.writeString(file, "scenario: s\nfactors: {f: {path: p, uniform: [1, 2]}}\n");
    assertEquals(1, CampaignReader.readForSearch(file).get(0).factors().size());
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> CampaignReader.read(file));
    assertEquals("campaign.size", refused.diagnostics().get(0).id());
  }

  @ParameterizedTest
  @CsvSource({"1/1", "2/5", "100/100"})
  void aShardIsANumberOfAll(String text) {
    Shard shard = Shard.parse(text);
    assertEquals(text, shard.number() + "/" + shard.count());
  }

  @ParameterizedTest
  @CsvSource({"0/5", "6/5", "1", "a/b", "1/0", "-1/2", "1/1000000"})
  void otherTextIsNoShard(String text) {
    assertThrows(IllegalArgumentException.class, () -> Shard.parse(text));
  }
}
