package dev.eventchain.m2t.editing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.editing.Answers;
import dev.eventchain.editing.MemoryWorkspace;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.fixtures.MarkedCase;
import dev.eventchain.fixtures.TestModels;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the answers of {@link TemplateLanguageService}, case by case. */
class TemplateEditingTest {

  private static final Path MAIN = Path.of("main.mtl");
  private static final int EDITS = 40;

  /** Texts that begin or end something; one of its ends is typed. */
  private static final String TYPED = "[for (x | y.->'::|)";

  private static final List<String> QUESTIONS =
      List.of(
          "symbols",
          "foldings",
          "tokens",
          "completions",
          "hover",
          "signatureHelp",
          "definitions",
          "typeDefinitions",
          "implementations",
          "references",
          "renameTarget",
          "rename other",
          "selectionRanges",
          "inlayHints",
          "incomingCalls",
          "outgoingCalls");

  private static final EPackage LIBRARY = new TestModels("library").metamodel();

  static Stream<MarkedCase> cases() {
    return MarkedCase.read(Path.of("src/test/resources/editing/cases.txt")).stream();
  }

  @ParameterizedTest
  @MethodSource("cases")
  void answers(MarkedCase marked) {
    MemoryWorkspace workspace = new MemoryWorkspace(List.of(LIBRARY));
    marked.files().forEach((name, text) -> workspace.put(Path.of(name), text));
    TextPosition position =
        new TextLines(marked.files().get(marked.file())).position(marked.offset());
    List<String> answer =
        Answers.to(
            marked.question(),
            new TemplateLanguageService(workspace),
            Path.of(marked.file()),
            position);
    assertEquals(List.of(), marked.faults(answer));
  }

  /** An analysis is kept until a text changes, and a closed file has none. */
  @Test
  void keepsAnswersByVersion() {
    MemoryWorkspace workspace = new MemoryWorkspace(List.of(LIBRARY));
    workspace.put(
        MAIN, "[module main('http://example.org/library')]\n[query one(b : Book) : Integer = 1/]");
    TemplateLanguageService service = new TemplateLanguageService(workspace);
    assertSame(service.analysis(MAIN).orElseThrow(), service.analysis(MAIN).orElseThrow());
    workspace.put(
        MAIN, "[module main('http://example.org/library')]\n[query two(b : Book) : Integer = 2/]");
    assertEquals("two", service.analysis(MAIN).orElseThrow().symbols().get(1).name());
    workspace.remove(MAIN);
    assertTrue(service.analysis(MAIN).isEmpty());
  }

  /** Whatever is typed or deleted, each question has an answer. */
  @Test
  void answersAboutAnyText() {
    String text =
        """
          [comment encoding = UTF-8 /]
          [module main('http://example.org/library')]
          [query public long(b : Book, limit : Integer) : Boolean = b.pages > limit /]
          [template public page(l : Library) {n : Integer = 3;}]
          [file (l.name.concat('.txt'), false, 'UTF-8')]
          [for (b : Book | l.books->select(c | c.long(n))) separator (', ')]
          [if (b.pages > 3)][b.title.toUpperFirst()/][elseif (true)]x[else]y[/if]
          [let t : String = b.title][t/][protected (t)]area[/protected][/let]
          [/for]
          [/file]
          [/template]
          """;
    MemoryWorkspace workspace = new MemoryWorkspace(List.of(LIBRARY));
    TemplateLanguageService service = new TemplateLanguageService(workspace);
    Random random = new Random(1);
    for (int i = 0; i < EDITS; i++) {
      int start = random.nextInt(text.length());
      int end = Math.min(text.length(), start + random.nextInt(12));
      String typed = TYPED.substring(random.nextInt(TYPED.length()));
      String edited = text.substring(0, start) + typed + text.substring(end);
      workspace.put(MAIN, edited);
      TextPosition position = new TextLines(edited).position(start + typed.length());
      QUESTIONS.forEach(each -> Answers.to(each, service, MAIN, position));
    }
    workspace.put(MAIN, text);
    assertTrue(service.analysis(MAIN).orElseThrow().symbols().size() > 1);
  }
}
