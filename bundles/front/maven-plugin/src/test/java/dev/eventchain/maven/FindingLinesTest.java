package dev.eventchain.maven;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.apache.maven.plugin.logging.SystemStreamLog;
import org.junit.jupiter.api.Test;

class FindingLinesTest {

  private static final SourceLocation PLACE =
      new SourceLocation("m/a.xmi", 3, 5, "Library/books[1]", "");

  private final List<String> lines = new ArrayList<>();

  private void print(List<Diagnostic> findings) {
    new FindingLines(
            new SystemStreamLog() {
              @Override
              public void error(CharSequence line) {
                lines.add("[ERROR] " + line);
              }

              @Override
              public void warn(CharSequence line) {
                lines.add("[WARNING] " + line);
              }
            })
        .print(findings);
  }

  @Test
  void namePlaceMessageIdAndRule() {
    Diagnostic error =
        Diagnostic.of(Rule.error("ocl.violated"), "No pages.", PLACE)
            .withRule("Book::HasPages")
            .withHint("Add some.");
    print(
        List.of(
            error,
            Diagnostic.of(Rule.warning("x.y"), "Odd.\n[ERROR] forged", SourceLocation.NONE)));
    assertEquals(
        List.of(
            "[ERROR] m/a.xmi:3:5: No pages. [ocl.violated Book::HasPages]",
            "[ERROR]   at: Library/books[1]",
            "[ERROR]   hint: Add some.",
            "[WARNING] Odd.\n    | [ERROR] forged [x.y]"),
        lines);
  }

  @Test
  void consequencesAreNamedBelowTheirCause() {
    Diagnostic cause = Diagnostic.of(Rule.error("a.b"), "Wrong.", PLACE);
    Diagnostic consequence =
        Diagnostic.of(Rule.error("a.c"), "Not tested.", SourceLocation.of("m/b.xmi"))
            .withCause(new Diagnostic.Cause(PLACE, "it stops\n[ERROR] forged"));
    print(List.of(cause, consequence));
    assertEquals(
        List.of(
            "[ERROR] m/a.xmi:3:5: Wrong. [a.b]",
            "[ERROR]   at: Library/books[1]",
            "[ERROR]   1 consequence: it stops\n    | [ERROR] forged"),
        lines);
  }

  @Test
  void oneRuleFillsNoScreens() {
    print(
        Collections.nCopies(102, Diagnostic.of(Rule.error("a.b"), "Wrong.", SourceLocation.NONE)));
    assertEquals(101, lines.size());
    assertEquals("[WARNING] ... and 2 more [a.b]", lines.get(100));
  }
}
