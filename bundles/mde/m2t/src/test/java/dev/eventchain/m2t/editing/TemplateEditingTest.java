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
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the answers of {@link TemplateLanguageService}, case by case. */
class TemplateEditingTest {

  private static final Path MAIN = Path.of("main.mtl");
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
}
