package dev.eventchain.eclipse.tests;

import static dev.eventchain.eclipse.tests.TextEditors.MAIN;
import static dev.eventchain.eclipse.tests.TextEditors.RULES;
import static dev.eventchain.eclipse.tests.TextEditors.configuration;
import static dev.eventchain.eclipse.tests.TextEditors.document;
import static dev.eventchain.eclipse.tests.TextEditors.viewer;
import static dev.eventchain.eclipse.tests.TextEditors.widget;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.constraints.editing.RuleLanguageService;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.LanguageService;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.Workspace;
import dev.eventchain.m2t.editing.TemplateLanguageService;
import dev.eventchain.model.eventchain.EventchainPackage;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.ITextHover;
import org.eclipse.jface.text.ITextHoverExtension2;
import org.eclipse.jface.text.Region;
import org.eclipse.jface.text.contentassist.ContentAssistant;
import org.eclipse.jface.text.contentassist.ICompletionProposal;
import org.eclipse.jface.text.contentassist.ICompletionProposalExtension2;
import org.eclipse.jface.text.contentassist.IContentAssistProcessor;
import org.eclipse.jface.text.source.projection.ProjectionAnnotationModel;
import org.eclipse.ui.editors.text.TextEditor;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests that the editors of texts say what the analysis of the engine says. */
class CodeQuestionsTest {

  private TestProject project;

  @BeforeEach
  void create() throws Exception {
    Workbench.require();
    project = TestProject.create("questions");
  }

  @AfterEach
  void close() throws Exception {
    Workbench.close(project);
  }

  /** A workspace of one text, about chains. */
  private record OneText(Path file, SourceText text) implements Workspace {

    @Override
    public List<Path> files() {
      return List.of(file);
    }

    @Override
    public Optional<SourceText> text(Path asked) {
      return Optional.of(text).filter(each -> asked.equals(file));
    }

    @Override
    public List<EPackage> metamodels(Path asked) {
      return List.of(EventchainPackage.eINSTANCE);
    }
  }

  /** Returns the analysis by the engine itself. */
  private Analysis analysis(String name, String text) {
    Path file = project.file(name).getLocation().toPath();
    Workspace workspace = new OneText(file, SourceText.of(file.toString(), text));
    LanguageService service =
        name.endsWith(".ocl")
            ? new RuleLanguageService(workspace)
            : new TemplateLanguageService(workspace);
    return service.analysis(file).orElseThrow();
  }

  private static ICompletionProposal[] proposals(TextEditor editor, int offset) throws Exception {
    ContentAssistant assistant =
        (ContentAssistant) configuration(editor).getContentAssistant(viewer(editor));
    IContentAssistProcessor processor =
        assistant.getContentAssistProcessor(IDocument.DEFAULT_CONTENT_TYPE);
    return processor.computeCompletionProposals(viewer(editor), offset);
  }

  @Test
  void proposalsAreThoseOfTheAnalysis() throws Exception {
    String half = RULES + "context EventChain\n  inv Half: self.so";
    TextEditor editor = Workbench.open(project.write("rules.ocl", RULES));
    Workbench.run(
        () -> {
          document(editor).set(half); // not saved
          return editor;
        });
    for (int offset : new int[] {0, half.indexOf("frequency"), half.length()}) {
      List<String> expected =
          analysis("rules.ocl", half).completions(new TextLines(half).position(offset)).stream()
              .filter(each -> offset < half.length() || each.label().startsWith("so"))
              .map(each -> each.label() + (each.detail().isEmpty() ? "" : "  " + each.detail()))
              .toList();
      List<String> listed =
          Arrays.stream(proposals(editor, offset)).map(each -> each.getDisplayString()).toList();
      assertEquals(expected, listed);
      assertTrue(!listed.isEmpty(), "at " + offset);
    }
  }

  @Test
  void templatesOfProposalsAreFilledIn() throws Exception {
    String text = MAIN.replace("[line(node)/]\n", "  [fo\n");
    TextEditor editor = Workbench.open(project.write("main.mtl", text));
    int offset = text.indexOf("[fo\n") + 3;
    ICompletionProposal loop =
        Arrays.stream(proposals(editor, offset))
            .filter(each -> each.getDisplayString().startsWith("for"))
            .findFirst()
            .orElseThrow();
    String selected =
        Workbench.run(
            () -> {
              Workbench.page().activate(editor);
              ((ICompletionProposalExtension2) loop).apply(viewer(editor), '\0', 0, offset);
              return widget(editor).getSelectionText();
            });
    String filled = Workbench.run(() -> document(editor).get());
    assertTrue(filled.contains("  [for (each | values)]\n  \n  [/for]\n"), filled);
    assertEquals("each", selected);
    Workbench.screenshot("text-snippet");
  }

  @Test
  void proposalsHaveTheLineEndsOfTheirText() throws Exception {
    String text = MAIN.replace("[line(node)/]\n", "  [fo\n").replace("\n", "\r\n");
    TextEditor editor = Workbench.open(project.write("main.mtl", text));
    int offset = text.indexOf("[fo\r") + 3;
    ICompletionProposal loop =
        Arrays.stream(proposals(editor, offset))
            .filter(each -> each.getDisplayString().startsWith("for"))
            .findFirst()
            .orElseThrow();
    String filled =
        Workbench.run(
            () -> {
              ((ICompletionProposalExtension2) loop).apply(viewer(editor), '\0', 0, offset);
              return document(editor).get();
            });
    assertEquals(
        text.replace("  [fo\r\n", "  [for (each | values)]\r\n  \r\n  [/for]\r\n"), filled);
  }

  @Test
  void hoverSaysWhatTheAnalysisSays() throws Exception {
    TextEditor editor = Workbench.open(project.write("rules.ocl", RULES));
    int offset = RULES.indexOf("frequency") + 2;
    String expected =
        analysis("rules.ocl", RULES)
            .hover(new TextLines(RULES).position(offset))
            .orElseThrow()
            .markdown();
    ITextHover hover = configuration(editor).getTextHover(viewer(editor), "");
    String shown =
        (String)
            ((ITextHoverExtension2) hover).getHoverInfo2(viewer(editor), new Region(offset, 0));
    assertTrue(shown.contains("frequency"), shown);
    assertEquals(expected.replace("```ocl\n", "").replace("\n```", ""), shown);
    assertEquals(
        new Region(RULES.indexOf("frequency"), "frequency".length()),
        hover.getHoverRegion(viewer(editor), offset));
  }

  @Test
  void foldingsAreThoseOfTheAnalysis() throws Exception {
    TextEditor editor = Workbench.open(project.write("main.mtl", MAIN));
    int expected = analysis("main.mtl", MAIN).foldings().size();
    assertTrue(expected > 0);
    Workbench.waitUntil(
        expected + " foldings",
        () -> {
          int[] count = {0};
          editor
              .getAdapter(ProjectionAnnotationModel.class)
              .getAnnotationIterator()
              .forEachRemaining(each -> count[0]++);
          return count[0] == expected;
        });
  }
}
