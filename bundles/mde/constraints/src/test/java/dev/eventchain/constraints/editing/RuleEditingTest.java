package dev.eventchain.constraints.editing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.editing.Answers;
import dev.eventchain.editing.MemoryWorkspace;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.fixtures.MarkedCase;
import dev.eventchain.fixtures.TestModels;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.xmi.impl.EcoreResourceFactoryImpl;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the answers of {@link RuleLanguageService}, case by case. */
class RuleEditingTest {

  private static final Path RULES = Path.of("rules.ocl");
  private static final EPackage LIBRARY = new TestModels("library").metamodel();

  static Stream<MarkedCase> cases() {
    return MarkedCase.read(Path.of("src/test/resources/editing/cases.txt")).stream();
  }

  @ParameterizedTest
  @MethodSource("cases")
  void answers(MarkedCase marked) {
    EPackage metamodel =
        marked.files().entrySet().stream()
            .filter(each -> each.getKey().endsWith(".ecore"))
            .findFirst()
            .map(each -> metamodel(each.getKey(), each.getValue()))
            .orElse(LIBRARY);
    MemoryWorkspace workspace = new MemoryWorkspace(List.of(metamodel));
    marked.files().forEach((name, text) -> workspace.put(Path.of(name), text));
    TextPosition position =
        new TextLines(marked.files().get(marked.file())).position(marked.offset());
    List<String> answer =
        Answers.to(
            marked.question(),
            new RuleLanguageService(workspace),
            Path.of(marked.file()),
            position);
    assertEquals(List.of(), marked.faults(answer));
  }

  private static EPackage metamodel(String file, String text) {
    Resource resource =
        new EcoreResourceFactoryImpl()
            .createResource(URI.createFileURI(Path.of(file).toAbsolutePath().toString()));
    try {
      resource.load(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), Map.of());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return (EPackage) resource.getContents().get(0);
  }

  /** An analysis is kept until a text changes, and a closed file has none. */
  @Test
  void keepsAnswersByVersion() {
    MemoryWorkspace workspace = new MemoryWorkspace(List.of(LIBRARY));
    workspace.put(RULES, "context Book def: long : Boolean = pages > 500");
    RuleLanguageService service = new RuleLanguageService(workspace);
    assertSame(service.analysis(RULES).orElseThrow(), service.analysis(RULES).orElseThrow());
    workspace.put(RULES, "context Book def: huge : Boolean = pages > 500");
    assertEquals(
        "huge", service.analysis(RULES).orElseThrow().symbols().get(0).children().get(0).name());
    workspace.remove(RULES);
    assertTrue(service.analysis(RULES).isEmpty());
  }
}
