package dev.eventchain.diagnostics.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class DiagnosticFormatTest {

  private static final Diagnostic VIOLATED =
      Diagnostic.of(
              Rule.error("ocl.violated"),
              "SoftwareNode 'TTC' has no output.",
              new SourceLocation(
                  "out/chain.xmi", 3, 7, "//@software.1", "\t<software name=\"TTC\"/>"))
          .withHint("Give it an output.")
          .withRule("SoftwareNode::HasInputAndOutputData")
          .withRelated(new SourceLocation("rules.ocl", 2, 5, "", ""));

  @Test
  void textShowsPlaceLineCaretElementAndHint() {
    assertEquals(
        """
        out/chain.xmi:3:7: error: SoftwareNode 'TTC' has no output. [ocl.violated SoftwareNode::HasInputAndOutputData]
            \t<software name="TTC"/>
            \t     ^
          at: //@software.1
          see: rules.ocl:2:5
          hint: Give it an output.
        """,
        DiagnosticFormat.TEXT.render(List.of(VIOLATED)));
  }

  @Test
  void textOfNothingIsEmpty() {
    assertEquals("", DiagnosticFormat.TEXT.render(List.of()));
  }

  @Test
  void ofManyFindingsOfOneRuleTheExcerptShowsTheFirstAndCountsTheOthers() {
    List<Diagnostic> many = new ArrayList<>(Collections.nCopies(5, VIOLATED));
    many.add(VIOLATED.withRule("SoftwareNode::Other"));
    String text = DiagnosticFormat.textExcerpt(Report.of(many), 2);
    assertEquals(3, text.lines().filter(line -> line.contains("error:")).count(), text);
    assertTrue(
        text.contains("... and 3 more [ocl.violated SoftwareNode::HasInputAndOutputData]\n"), text);
    assertEquals(6, DiagnosticFormat.TEXT.render(many).split("error:", -1).length - 1);
  }

  private static Diagnostic at(String element) {
    return Diagnostic.of(
        Rule.error("a.b"), "At " + element + ".", SourceLocation.NONE.withElement(element));
  }

  private static Diagnostic consequence(String name, Diagnostic cause) {
    return at(name).withCause(new Diagnostic.Cause(cause.location(), "the " + name));
  }

  @Test
  void theExcerptTellsACauseOnceAndNamesItsConsequences() {
    List<Diagnostic> found =
        List.of(
            consequence("first", at("cause")),
            at("cause"),
            consequence("second", at("cause")),
            at("other"));
    assertEquals(
        """
        error: At cause. [a.b]
          at: cause
          2 consequences: the first; the second
        error: At other. [a.b]
          at: other
        """,
        DiagnosticFormat.textExcerpt(Report.of(found), 2));
    assertEquals(4, DiagnosticFormat.textOfAll(Report.of(found)).split("error:", -1).length - 1);
    assertEquals(
        """
        error: At cause. [a.b]
          at: cause
          2 consequences: the first; the second
        ... and 1 more [a.b]
        """,
        DiagnosticFormat.textExcerpt(Report.of(found), 1));
    String json = DiagnosticFormat.JSON.render(Report.of(found));
    assertEquals(4, json.split("\"id\"", -1).length - 1, json);
    assertEquals(2, json.split("\"cause\" : \\{", -1).length - 1, json);
  }

  @Test
  void consequencesOfWhatIsNotShownAreShown() {
    List<Diagnostic> found = List.of(consequence("first", at("suppressed")), at("other"));
    String text = DiagnosticFormat.textExcerpt(Report.of(found), 9);
    assertEquals(2, text.split("error:", -1).length - 1, text);
    List<Diagnostic> two = List.of(at("a"), at("b"), consequence("of b", at("b")));
    assertEquals(
        """
        error: At a. [a.b]
          at: a
        ... and 2 more [a.b]
        """,
        DiagnosticFormat.textExcerpt(Report.of(two), 1));
  }

  @Test
  void nothingIsFoldedUnderAWarningAtTheSamePlace() {
    Diagnostic warning = at("cause").withSeverity(Severity.WARNING);
    List<Diagnostic> found = List.of(warning, consequence("first", at("cause")));
    String text = DiagnosticFormat.textExcerpt(Report.of(found), 9);
    assertTrue(text.contains("error: At first."), text);
  }

  @Test
  void whatIsUnknownIsLeftOut() {
    Diagnostic bare = Diagnostic.of(Rule.warning("a.b"), "Odd.", SourceLocation.NONE);
    assertEquals("warning: Odd. [a.b]\n", DiagnosticFormat.TEXT.render(List.of(bare)));
    String json = DiagnosticFormat.JSON.render(List.of(bare));
    assertFalse(json.contains("line"), json);
    assertFalse(json.contains("hint"), json);
  }

  @Test
  void jsonHoldsEverything() {
    String json = DiagnosticFormat.JSON.render(List.of(VIOLATED));
    for (String part :
        List.of(
            "ocl.violated",
            "error",
            "\"line\" : 3",
            "\"column\" : 7",
            "//@software.1",
            "\"file\" : \"rules.ocl\"",
            "\"line\" : 2")) {
      assertTrue(json.contains(part), json);
    }
  }

  @Test
  void longLinesAreCutAroundTheCaret() {
    String line = "x".repeat(5000) + "HERE" + "y".repeat(5000);
    Diagnostic wide =
        Diagnostic.of(Rule.error("a.b"), "Odd.", new SourceLocation("f", 1, 5001, "", line));
    List<String> lines = DiagnosticFormat.TEXT.render(List.of(wide)).lines().toList();
    assertTrue(lines.get(1).length() < 200, "excerpt of " + lines.get(1).length());
    assertEquals('H', lines.get(1).charAt(lines.get(2).indexOf('^')));
  }

  @Test
  void textFromModelsCannotSteerTheTerminal() {
    Diagnostic nasty = Diagnostic.of(Rule.error("a.b"), "\u001b[2Jgone", SourceLocation.NONE);
    assertFalse(DiagnosticFormat.TEXT.render(List.of(nasty)).contains("\u001b"));
  }

  @Test
  void textFromModelsCannotPassForAFindingOfItsOwn() {
    Diagnostic forged =
        Diagnostic.of(
            Rule.error("a.b"), "x\nmodel:1:1: error: fake \u202Eabc", SourceLocation.NONE);
    String text = DiagnosticFormat.TEXT.render(List.of(forged));
    assertEquals("error: x\n    | model:1:1: error: fake \\u202eabc [a.b]\n", text);
  }

  @Test
  void whatAForeignProgramSaysIsOneShortLine() {
    assertEquals(
        "\\x1b[2J\\nPASSED: 7 of 7 \\x9b\\u2028.",
        Printable.line("\u001b[2J\nPASSED: 7 of 7\t\u009b\u2028."));
    assertEquals(401, Printable.line("x".repeat(100_000)).length());
  }

  @Test
  void columnsOfAnExcerptStay() {
    SourceLocation place = new SourceLocation("f", 1, 3, "", "\u001b\nx");
    String text =
        DiagnosticFormat.TEXT.render(List.of(Diagnostic.of(Rule.error("a.b"), "m", place)));
    assertEquals("f:1:3: error: m [a.b]\n    \uFFFD\uFFFDx\n      ^\n", text);
  }

  @Test
  void placesThatAreNowhereAreNotRelated() {
    assertEquals(List.of(), VIOLATED.withRelated(SourceLocation.NONE).related());
  }

  @Test
  void theOrderIsTotal() {
    Diagnostic none = Diagnostic.of(Rule.error("a"), "m", SourceLocation.NONE);
    Diagnostic one = none.withRelated(SourceLocation.of("a"));
    Diagnostic two = none.withRelated(SourceLocation.of("a"), SourceLocation.of("b"));
    assertEquals(List.of(none, one, two), Stream.of(two, none, one).sorted().toList());
    assertEquals(0, one.compareTo(none.withRelated(SourceLocation.of("a"))));
  }

  @Test
  void findingsSortByPlaceThenSeverity() {
    Diagnostic warning =
        Diagnostic.of(Rule.warning("z"), "w", new SourceLocation("a", 1, 1, "", ""));
    Diagnostic error = Diagnostic.of(Rule.error("z"), "e", new SourceLocation("a", 1, 1, "", ""));
    Diagnostic later = Diagnostic.of(Rule.error("a"), "l", new SourceLocation("a", 2, 1, "", ""));
    assertEquals(
        List.of(error, warning, later), Stream.of(later, warning, error).sorted().toList());
  }
}
