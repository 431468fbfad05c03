package dev.eventchain.pipeline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests which cases a campaign file means. */
class CaseListTest {

  private static final String TWO =
      """
      scenario: s
      factors:
        speed: {path: ego.speed_kmh, from: 10, to: 30, step: 10}
        gap: {path: "actors[0].gap_m", values: [5, 0.5]}
      """;

  private static final String DRAWN =
      """
      scenario: s
      factors:
        a: {path: a, uniform: [0, 10]}
        b: {path: b, uniform: [-1, 1]}
        c: {path: c, values: [1, 2, 3, 4]}
      """;

  @TempDir Path folder;

  private List<CampaignCase> cases(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("c.yaml"), text);
    return new CaseList(CampaignReader.read(file).get(0)).cases();
  }

  private static List<String> values(List<CampaignCase> cases) {
    return cases.stream().map(each -> each.values() + " " + each.repetition()).toList();
  }

  @Test
  void aGridHasAllCombinationsInTheOrderOfTheirValues() throws IOException {
    assertEquals(
        List.of("[10, 0.5] 1", "[10, 5] 1", "[20, 0.5] 1", "[20, 5] 1", "[30, 0.5] 1", "[30, 5] 1"),
        values(cases(TWO)));
  }

  @Test
  void conditionsKeepCombinationsAndRepetitionsRepeatThem() throws IOException {
    List<CampaignCase> cases =
        cases(TWO + "where: [gap * 10 > speed, speed < 25 or gap < 1]\nrepetitions: 2\n");
    assertEquals(List.of("[10, 5] 1", "[10, 5] 2", "[20, 5] 1", "[20, 5] 2"), values(cases));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "where: [gap > sped]; campaign.condition",
        "where: [gap > 1000]; campaign.empty",
      })
  void whatLeavesNothingOrNamesNothingIsFound(String more, String rule) throws IOException {
    DiagnosticException refused = assertThrows(DiagnosticException.class, () -> cases(TWO + more));
    assertEquals(rule, refused.diagnostics().get(0).id());
  }

  @Test
  void aGridOfABillionIsRefused() {
    StringBuilder text = new StringBuilder("scenario: s\nfactors:\n");
    for (int i = 0; i < 9; i++) {
      text.append(
          String.format(Locale.ROOT, "  f%d: {path: a%d, from: 1, to: 10, step: 1}\n", i, i));
    }
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> cases(text.toString()));
    assertEquals("campaign.size", refused.diagnostics().get(0).id());
  }

  @ParameterizedTest
  @ValueSource(strings = {"random", "latin_hypercube", "halton"})
  void drawsAreTheSameEachTimeAndWithinTheirBounds(String kind) throws IOException {
    String text = DRAWN + "sampling: {" + kind + ": 200}\n";
    List<CampaignCase> cases = cases(text);
    assertEquals(values(cases), values(cases(text)));
    assertEquals(200, cases.size());
    for (CampaignCase each : cases) {
      assertTrue(each.values().get(0).signum() >= 0 && each.values().get(0).doubleValue() < 10);
      assertTrue(each.values().get(1).abs().doubleValue() <= 1);
    }
    assertEquals(
        Set.of("1", "2", "3", "4"),
        new HashSet<>(cases.stream().map(each -> each.values().get(2).toString()).toList()));
    if (!kind.equals("halton")) {
      assertTrue(!values(cases).equals(values(cases(text + "seed: 2\n"))));
    }
  }

  /** A Latin hypercube has one value in each of as many equal parts as it has cases. */
  @Test
  void aLatinHypercubeFillsEachRangeEvenly() throws IOException {
    Set<Integer> parts = new TreeSet<>();
    for (CampaignCase each : cases(DRAWN + "sampling: {latin_hypercube: 50}\n")) {
      parts.add(each.values().get(0).multiply(BigDecimal.valueOf(5)).intValue());
    }
    assertEquals(50, parts.size());
  }

  /** The first points of the Halton sequence of bases 2 and 3 (Halton 1960). */
  @Test
  void theHaltonSequenceIsThatOfItsDefinition() throws IOException {
    List<CampaignCase> cases = cases(DRAWN + "sampling: {halton: 4}\n");
    assertEquals(
        List.of("1.25, -0.1111111", "2.5, 0.3333333", "5, -0.3333333", "7.5, -0.7777778"),
        cases.stream()
            .map(
                each ->
                    each.values().get(0)
                        + ", "
                        + each.values()
                            .get(1)
                            .setScale(7, java.math.RoundingMode.HALF_EVEN)
                            .toPlainString())
            .toList());
  }

  @Test
  void pairsHaveAnyTwoValuesTogetherInFewCases() throws IOException {
    StringBuilder text = new StringBuilder("scenario: s\nfactors:\n");
    for (int i = 0; i < 5; i++) {
      text.append(String.format(Locale.ROOT, "  f%d: {path: a%d, values: [1, 2, 3, 4]}\n", i, i));
    }
    List<CampaignCase> cases = cases(text + "sampling: {pairs: true}\n");
    Set<String> pairs = new HashSet<>();
    for (CampaignCase each : cases) {
      for (int a = 0; a < 5; a++) {
        for (int b = a + 1; b < 5; b++) {
          pairs.add(a + "=" + each.values().get(a) + " " + b + "=" + each.values().get(b));
        }
      }
    }
    assertEquals(10 * 16, pairs.size());
    assertTrue(cases.size() < 32, cases.size() + " of 1024, at least 16");
  }

  /** The first completion of a pair is refused here, another one is not. */
  @Test
  void pairsAreTriedInOtherCombinationsWhereOneIsRefused() throws IOException {
    String text =
        """
        scenario: s
        factors:
          a: {path: a, values: [1, 2]}
          b: {path: b, values: [1, 2]}
          c: {path: c, values: [1, 2]}
        where: ["c > 1"]
        sampling: {pairs: true}
        """;
    assertEquals(
        List.of("[1, 1, 2] 1", "[1, 2, 2] 1", "[2, 1, 2] 1", "[2, 2, 2] 1"), values(cases(text)));
  }

  @Test
  void whatTakesTooMuchIsRefused() {
    String long200 = "{path: a, from: 1, to: 200, step: 1}";
    String pairs = "scenario: s\nfactors: {a: %s, b: %s}\nsampling: {pairs: true}\n";
    for (String text :
        List.of(
            DRAWN + "sampling: {random: 1000000}\nrepetitions: 2\n",
            pairs.formatted(long200, long200.replace("path: a", "path: b")))) {
      DiagnosticException refused = assertThrows(DiagnosticException.class, () -> cases(text));
      assertEquals("campaign.size", refused.diagnostics().get(0).id());
    }
  }

  @Test
  void aTableGivesTheValuesOfAColumn() throws IOException {
    Files.writeString(folder.resolve("t.csv"), "x,gap\n1,10\n2, 12.50\n3,10\n");
    assertEquals(
        List.of("[10] 1", "[12.5] 1"),
        values(cases("scenario: s\nfactors: {g: {path: a, csv: t.csv, column: gap}}\n")));
  }

  @Test
  void rowsOfATableAreCasesAndTextsMayBeNumbers() throws IOException {
    Files.writeString(folder.resolve("t.csv"), "road,gap\nwet,10\ndry,20\nwet,10\nwet,5\n");
    String text =
        """
        scenario: s
        factors:
          road: {path: a, csv: t.csv, column: road, numbers: {dry: 0.9, wet: 0.5}}
          gap: {path: b, csv: t.csv, column: gap}
        sampling: {rows: true}
        """;
    assertEquals(List.of("[0.5, 5] 1", "[0.5, 10] 1", "[0.9, 20] 1"), values(cases(text)));
    assertEquals(List.of("[0.9, 20] 1"), values(cases(text + "where: [gap > 15]\n")));
  }

  @Test
  void whatIsComputedFollowsFromTheFactors() throws IOException {
    String text =
        """
        scenario: s
        factors:
          speed: {path: v, values: [3.6]}
          gap: {values: [10]}
        computed:
          time: {formula: ceil(gap / 4)}
          start: {paths: [a, b], formula: gap + speed / 3.6 * time}
        """;
    CampaignPlan plan =
        CampaignReader.read(Files.writeString(folder.resolve("c.yaml"), text)).get(0);
    CampaignCase only = new CaseList(plan).cases().get(0);
    assertEquals("{v=3.6, a=13.0, b=13.0}", plan.settings(only).toString());
  }

  @Test
  void aComputedNumberNeedsAValue() throws IOException {
    String text =
        """
        scenario: s
        factors: {speed: {values: [0]}}
        computed: {time: {path: a, formula: 10 / speed}}
        """;
    CampaignPlan plan =
        CampaignReader.read(Files.writeString(folder.resolve("c.yaml"), text)).get(0);
    CampaignCase only = new CaseList(plan).cases().get(0);
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> plan.settings(only));
    assertEquals("campaign.formula", refused.diagnostics().get(0).id());
  }
}
