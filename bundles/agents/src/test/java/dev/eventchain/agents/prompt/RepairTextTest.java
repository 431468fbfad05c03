package dev.eventchain.agents.prompt;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.agents.FindingLines;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Findings for a language model mention no files and options, which it does not see. The tests of
 * the single tasks check the findings of their fixtures.
 */
class RepairTextTest {
  private static final Pattern FILES = FindingLines.FILES;

  /** The bundles whose findings may concern an answer. */
  private static final List<String> CHECKING =
      List.of(
          "agents",
          "chain/contracts",
          "chain/description",
          "chain/project",
          "mde/constraints",
          "mde/documents",
          "mde/json-models",
          "mde/ocl",
          "robot/messages",
          "robot/sandbox");

  private static final Pattern LITERAL = Pattern.compile("\"((?:[^\"\\\\\n]++|\\\\.)*+)\"");

  @Test
  void clausesAboutFilesAndOptionsAreLeftOut() {
    Diagnostic finding =
        Diagnostic.of(Rule.error("any.id"), "It is wrong.", SourceLocation.NONE)
            .withHint(
                "Did you mean `a`? Known is b; name another one with --metamodel FILE.ecore.");
    String text = FindingsText.of("answer", List.of(finding));
    assertTrue(text.endsWith("   Did you mean `a`? Known is b.\n"), text);
  }

  /**
   * Quotes the hint of {@code contract.unit.mismatch}: recorded prompts have its first sentence.
   */
  @Test
  void aSentenceForPeopleIsLeftOut() {
    Diagnostic finding =
        Diagnostic.of(Rule.error("any.id"), "It is wrong.", SourceLocation.NONE)
            .withHint(
                "Give it in 1: divide by 100. Or let the generated node convert: unit '1' and component_unit '%' in chain.json and components.json (unit and componentUnit in a model).");
    String text = FindingsText.of("answer", List.of(finding));
    assertTrue(text.endsWith("   Give it in 1: divide by 100.\n"), text);
  }

  /** All text literals of the checking bundles, whatever finding they belong to. */
  @Test
  void noTextOfAnyFindingSpeaksOfFiles() throws IOException {
    Set<String> texts = new TreeSet<>();
    for (String bundle : CHECKING) {
      try (Stream<Path> files = Files.walk(Path.of("..", bundle, "src/main/java"))) {
        for (Path file : files.filter(path -> path.toString().endsWith(".java")).toList()) {
          Matcher found = LITERAL.matcher(Files.readString(file).replaceAll("\"\\s*\\+ *\"", ""));
          while (found.find()) {
            texts.add(found.group(1).replace("\\\"", "\""));
          }
        }
      }
    }
    assertTrue(texts.stream().filter(text -> FILES.matcher(text).find()).count() > 20);
    texts.removeIf(text -> !text.contains(" "));
    for (String text : texts) {
      Diagnostic finding = Diagnostic.of(Rule.error("any.id"), "It is wrong.", SourceLocation.NONE);
      String hint = FindingsText.of("answer", List.of(finding.withHint(text)));
      assertFalse(FILES.matcher(hint).find(), hint);
      String message =
          FindingsText.of(
              "answer", List.of(Diagnostic.of(Rule.error("any.id"), text, SourceLocation.NONE)));
      assertFalse(message.contains(" file ") || message.contains(" file."), message);
    }
  }
}
