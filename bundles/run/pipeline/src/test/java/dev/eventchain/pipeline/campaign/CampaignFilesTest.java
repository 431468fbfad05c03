package dev.eventchain.pipeline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Campaign files that are checked by themselves. */
class CampaignFilesTest {

  @TempDir private Path project;

  private Path write(String text) throws IOException {
    Path file = project.resolve("campaigns/c.yaml");
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private List<String> ids() {
    return CampaignFiles.problems(project).stream().map(Diagnostic::id).toList();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "true  | factors: {}",
        "true  | \"factors\": {}",
        "true  | {scenario: a}",
        "true  | {scenaro: a, factrs: {}}",
        "true  | campaings: {a: {}}",
        "true  | \"scenario\": [",
        "false | cases: 3",
        "false | {scenarios: [a]}",
        "false | campaign: a",
        "false | {other: {factors: 1}}",
        "false | [factors]",
        "false | cases: [",
        "false | # nothing",
      })
  void areKnownByTheirKeys(boolean expected, String text) {
    assertEquals(expected, CampaignFiles.isCampaign(text));
  }

  @Test
  void areReportedWithAllKeysMisspelt() throws IOException {
    write("scenaro: a\nfactrs: {}\n");
    assertEquals(
        List.of(
            "campaign.key.missing",
            "campaign.key.missing",
            "campaign.key.unknown",
            "campaign.key.unknown"),
        ids().stream().sorted().toList());
  }

  /** A name that no file can have keeps nothing else from being found. */
  @Test
  void mayNameWhatIsNoPath() throws IOException {
    String factor = "factors:\n  gap: {path: a, csv: \"t\\0.csv\", column: b}\n";
    write("scenario: \"a\\0b\"\nsede: 1\n" + factor);
    List<String> found = ids();
    assertEquals(
        List.of(
            "campaign.key.unknown",
            "campaign.value.range",
            "campaign.value.type",
            "campaign.value.type"),
        found.stream().sorted().toList());
  }

  /** A campaign has all of the factors of the file that it plays, and a search none of them. */
  @Test
  void areReportedIfEachReaderHasItsOwnReason() throws IOException {
    Path sets = Path.of("src/test/resources/openscenario/sets.xosc").toAbsolutePath();
    write("scenario: " + sets + "\naccept: [no_impact]\n");
    assertEquals(List.of(), CampaignFiles.problems(project));
    write(
        "scenario: "
            + sets
            + "\naccept: [no_impact]\nboundary: {factor: nothing, resolution: 1}\n");
    assertEquals(List.of("campaign.factor"), ids());
  }
}
