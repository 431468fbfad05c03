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
import java.util.Random;
import java.util.stream.Stream;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.emf.ecore.xmi.impl.EcoreResourceFactoryImpl;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the answers of {@link RuleLanguageService}, case by case. */
class RuleEditingTest {

  private static final Path RULES = Path.of("rules.ocl");
  private static final int EDITS = 40;
  private static final int METAMODEL_EDITS = 200;

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

  /** However often a metamodel changes, only its present version is kept. */
  @Test
  void forgetsFormerMetamodels() {
    MemoryWorkspace workspace = new MemoryWorkspace(List.of(LIBRARY));
    workspace.put(RULES, "context Book def: long : Boolean = true inv A: self.long");
    workspace.put(Path.of("other/rules.ocl"), "context Book inv A: pages > 0");
    RuleLanguageService service = new RuleLanguageService(workspace);
    for (int i = 0; i < METAMODEL_EDITS; i++) {
      workspace.setMetamodels(List.of(EcoreUtil.copy(LIBRARY)));
      assertTrue(service.analysis(RULES).isPresent());
      assertTrue(service.worlds() <= 2);
    }
    assertTrue(service.analysis(Path.of("other/rules.ocl")).isPresent());
    assertEquals(2, service.worlds());
  }

  /** An import counts as long as it is written, whoever writes it. */
  @Test
  void noticesImports() {
    MemoryWorkspace workspace = new MemoryWorkspace(List.of(LIBRARY));
    RuleLanguageService service = new RuleLanguageService(workspace);
    Path other = Path.of("other/rules.ocl");
    String uses = "context Book inv A: self.long";
    TextPosition end = new TextPosition(1, uses.length());
    workspace.put(RULES, "\n" + uses);
    workspace.put(other, "\ncontext Book def: long : Boolean = true");
    assertEquals(List.of(), Answers.to("definitions", service, RULES, end));
    List<String> declared = List.of("rules.ocl 1:18-1:22");
    workspace.put(RULES, "import 'other/rules.ocl'\n" + uses);
    assertEquals(declared, Answers.to("definitions", service, RULES, end));
    workspace.put(RULES, "\n" + uses);
    assertEquals(List.of(), Answers.to("definitions", service, RULES, end));
    workspace.put(other, "import '../rules.ocl'\ncontext Book def: long : Boolean = true");
    assertEquals(declared, Answers.to("definitions", service, RULES, end));
    workspace.remove(other);
    assertEquals(List.of(), Answers.to("definitions", service, RULES, end));
  }

  /** An attribute that becomes an operation is proposed as one. */
  @Test
  void noticesParentheses() {
    MemoryWorkspace workspace = new MemoryWorkspace(List.of(LIBRARY));
    RuleLanguageService service = new RuleLanguageService(workspace);
    for (String parentheses : List.of("", "()")) {
      String text = "context Book def: long" + parentheses + " : Boolean = true inv A: self.lon";
      workspace.put(RULES, text);
      List<String> found =
          Answers.to("completions", service, RULES, new TextPosition(0, text.length()));
      String wanted = "DEFINITION long [long" + parentheses + "]";
      assertTrue(found.stream().anyMatch(each -> each.startsWith(wanted)), found::toString);
    }
  }

  /** Whatever is typed or deleted, each question has an answer. */
  @Test
  void answersAboutAnyText() {
    String text =
        """
          context Library
            -- All of them. @hint none
            inv A: let many : Integer = books->size(), few = 2 in
              books->forAll(b, c | b.title <> c.title implies many > few) and members->isEmpty()
          context Book
            def: isLong(limit : Integer) : Boolean = self.pages > limit and genre = Genre::NOVEL
            inv B: if isLong(3) then title.substring(1, 2) = 'x' else true endif
          """;
    MemoryWorkspace workspace = new MemoryWorkspace(List.of(LIBRARY));
    RuleLanguageService service = new RuleLanguageService(workspace);
    Random random = new Random(1);
    for (int i = 0; i < EDITS; i++) {
      int start = random.nextInt(text.length());
      int end = Math.min(text.length(), start + random.nextInt(12));
      String typed = TYPED.substring(random.nextInt(TYPED.length()));
      String edited = text.substring(0, start) + typed + text.substring(end);
      workspace.put(RULES, edited);
      TextPosition position = new TextLines(edited).position(start + typed.length());
      QUESTIONS.forEach(each -> Answers.to(each, service, RULES, position));
    }
    workspace.put(RULES, text);
    assertTrue(service.analysis(RULES).orElseThrow().symbols().size() > 1);
  }
}
