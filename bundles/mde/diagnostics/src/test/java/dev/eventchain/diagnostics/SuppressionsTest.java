package dev.eventchain.diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Suppressions.Entry;
import dev.eventchain.diagnostics.format.Reports;
import java.time.LocalDate;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SuppressionsTest {

  private static final LocalDate LAST_DAY = LocalDate.of(2026, 12, 24);
  private static final Diagnostic FINDING =
      Diagnostic.of(
              Rule.error("ocl.violated"),
              "'TTC' is 20.0 Hz.",
              new SourceLocation("a/model/chain.xmi", 3, 1, "EventChain[a]/software[TTC]", ""))
          .withRule("SoftwareNode::Fast");

  @ParameterizedTest
  @CsvSource({
    "ocl.violated,,,,,true",
    "ocl.undefined,,,,,false",
    "ocl.violated,SoftwareNode::Fast,,,,true",
    "ocl.violated,SoftwareNode::Fas,,,,false",
    "ocl.violated,*::Fast,EventChain[a]/software[*],,,true",
    "ocl.violated,,EventChain[a]/software[X*],,,false",
    "ocl.violated,,,a/model/chain.xmi,,true",
    "ocl.violated,,,chain.xmi,,true",
    "ocl.violated,,,ain.xmi,,false",
    "ocl.violated,,,,'''TTC''*',true",
    "ocl.violated,,,,.*,false",
  })
  void allPartsOfAnEntryMustMatch(
      String id, String rule, String element, String file, String message, boolean matches) {
    Entry entry =
        new Entry(
            id,
            text(rule),
            text(element),
            text(file),
            text(message),
            "known",
            LAST_DAY,
            SourceLocation.NONE);
    assertEquals(matches, entry.matches(FINDING));
  }

  private static String text(String value) {
    return value == null ? "" : value;
  }

  @Test
  void aMatchingFindingIsSuppressedUpToTheLastDayAndCountsAfterIt() {
    Suppressions onTheDay = new Suppressions(List.of(entry("ocl.violated")), LAST_DAY);
    assertEquals(List.of(), onTheDay.part(List.of(FINDING)).remaining());
    assertEquals("known", onTheDay.part(List.of(FINDING)).suppressed().get(0).by().reason());
    assertEquals(List.of(), onTheDay.warnings(List.of(FINDING), Coverage.NONE, true));
    Suppressions later = new Suppressions(List.of(entry("ocl.violated")), LAST_DAY.plusDays(1));
    assertEquals(List.of(FINDING), later.part(List.of(FINDING)).remaining());
    List<Diagnostic> over = later.warnings(List.of(), Coverage.NONE, true);
    assertEquals(List.of("suppression.expired"), over.stream().map(Diagnostic::id).toList());
  }

  @Test
  void anEntryThatMatchesNothingIsStaleIfItsFindingsWereLookedFor() {
    Suppressions suppressions =
        new Suppressions(List.of(entry("ocl.violated"), entry("ocl.undefined")), LAST_DAY);
    List<Diagnostic> stale = suppressions.warnings(List.of(FINDING), Coverage.NONE, true);
    assertEquals(1, stale.size());
    assertTrue(stale.get(0).message().contains("ocl.undefined"), stale.get(0).message());
    assertEquals(List.of(), suppressions.warnings(List.of(), Coverage.NONE, false));
  }

  @Test
  void anEntryIsAboutTheChecksOfItsKindInTheFilesThatWereChecked() {
    Coverage coverage = Reports.full().coverage();
    assertTrue(isJudged(entry("ocl.undefined"), coverage));
    assertFalse(isJudged(entry("agents.order"), coverage));
    assertFalse(isJudged(entry("ocl.violated"), Coverage.NONE));
    Entry elsewhere =
        new Entry("ocl.violated", "", "", "b.xmi", "", "known", LAST_DAY, SourceLocation.NONE);
    assertFalse(isJudged(elsewhere, coverage));
  }

  /**
   * Returns whether an entry counts as stale when nothing was found: if checks for its findings
   * ran.
   */
  private static boolean isJudged(Entry entry, Coverage coverage) {
    return !new Suppressions(List.of(entry), LAST_DAY)
        .warnings(List.of(), coverage, false)
        .isEmpty();
  }

  @Test
  void whatSaysThatSomethingWasNotCheckedCannotBeSuppressed() {
    String id = "a.b";
    Rule rule = Rule.error(id, CommonTrait.UNSUPPRESSIBLE);
    Diagnostic finding = Diagnostic.of(rule, "m", SourceLocation.NONE);
    Suppressions suppressions = new Suppressions(List.of(entry(id)), LAST_DAY);
    assertEquals(List.of(finding), suppressions.part(List.of(finding)).remaining());
  }

  @Test
  void anEntryNeedsAReason() {
    assertThrows(
        IllegalArgumentException.class,
        () -> new Entry("a.b", "", "", "", "", " ", LAST_DAY, SourceLocation.NONE));
  }

  private static Entry entry(String id) {
    return new Entry(id, "", "", "", "", "known", LAST_DAY, SourceLocation.NONE);
  }
}
