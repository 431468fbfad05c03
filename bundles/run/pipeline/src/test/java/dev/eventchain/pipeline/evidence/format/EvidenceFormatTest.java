package dev.eventchain.pipeline.evidence.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.Evidence.Requirement;
import dev.eventchain.pipeline.evidence.Evidence.Strength;
import dev.eventchain.pipeline.evidence.Evidence.Verdict;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class EvidenceFormatTest {

  private static final Path EXPECTED =
      Path.of("src/test/resources/dev/eventchain/pipeline/evidence/format");

  @ParameterizedTest
  @CsvSource({
    "EVIDENCE, evidence.lit.junit.xml",
    "LOBSTER, lobster",
    "NEEDS, needs.json",
    "MATRIX, matrix.csv"
  })
  void evidenceWithOneOfEverythingGivesTheseBytes(EvidenceFormat format, String name)
      throws Exception {
    Path target = EXPECTED.resolve(name);
    for (Map.Entry<String, byte[]> file : format.render(Evidences.full(), target).entrySet()) {
      ExpectedFile.check(
          target.resolve(file.getKey()), new String(file.getValue(), StandardCharsets.UTF_8));
    }
  }

  @ParameterizedTest
  @EnumSource
  void evidenceOfNothingCanBeWritten(EvidenceFormat format) throws Exception {
    Path target = Path.of("x.html");
    assertEquals(
        format.files(target), List.copyOf(format.render(Evidences.none(), target).keySet()));
  }

  @Test
  void thePageEscapesTextsAndNamesWhatDidNotPass() throws Exception {
    Path target = Path.of("Evidence.HTML");
    String page =
        new String(
            EvidenceFormat.MATRIX.render(Evidences.full(), target).get(""), StandardCharsets.UTF_8);
    for (String part :
        List.of(
            "<h1>Brake &amp; &lt;warn&gt;</h1>",
            "&lt;b&gt;and&lt;/b&gt;",
            "<span class=\"mark is-bad\">violated</span>",
            "notices 3 of 14 faults",
            "<span class=\"mark is-open\">not tested</span> scenario fog: *it* &lt;warns&gt;",
            "<span class=\"mark is-open\">not tested</span> Warning: lamp: It did not run.",
            "<span class=\"mark is-bad\">failed</span> late: not met: the vehicle stops",
            "<span class=\"mark is-good\">1 passed</span>")) {
      assertTrue(page.contains(part), part);
    }
  }

  @Test
  void aRequirementIsFullyVerifiedOnlyIfAllItsFaultsWereDrivenAndNoticed() {
    assertTrue(isFull(Verdict.PROVED, 14, 14, OptionalLong.empty()));
    assertFalse(isFull(Verdict.PROVED, 13, 14, OptionalLong.empty()));
    assertFalse(isFull(Verdict.PROVED, 14, 14, OptionalLong.of(20)), "a sample");
    assertFalse(isFull(Verdict.PROVED, 0, 0, OptionalLong.empty()), "nothing was asked");
    assertFalse(isFull(Verdict.NOT_TESTED, 14, 14, OptionalLong.empty()));
    assertFalse(isFull(Verdict.VIOLATED, 14, 14, OptionalLong.empty()));
    assertFalse(Evidences.full().requirement("BRK-3").orElseThrow().isFullyVerified());
  }

  private static boolean isFull(Verdict verdict, int noticed, int faults, OptionalLong sampleOf) {
    Requirement some = Evidences.full().requirements().get(0);
    return new Requirement(
            some.id(),
            some.text(),
            some.place(),
            verdict,
            Optional.empty(),
            Optional.of(new Strength(noticed, faults, sampleOf)))
        .isFullyVerified();
  }

  @Test
  void aTestIsLinkedToTheRequirementsForWhichItsResultHolds() {
    Evidence evidence = Evidences.full();
    List<List<String>> supported = evidence.tests().stream().map(evidence::supportedBy).toList();
    assertEquals(
        List.of(
            List.of("BRK-1"),
            List.of("BRK-3"),
            List.of("BRK-4"),
            List.of("BRK-1", "BRK-2"),
            List.of("BRK-3"),
            List.of("BRK-4")),
        supported);
  }
}
