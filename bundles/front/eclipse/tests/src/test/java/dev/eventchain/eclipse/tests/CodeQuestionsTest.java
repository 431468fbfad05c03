package dev.eventchain.eclipse.tests;

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
import org.eclipse.jface.text.ITextViewer;
import org.eclipse.jface.text.Region;
import org.eclipse.jface.text.contentassist.ContentAssistant;
import org.eclipse.jface.text.contentassist.ICompletionProposal;
import org.eclipse.jface.text.contentassist.ICompletionProposalExtension2;
import org.eclipse.jface.text.contentassist.IContentAssistProcessor;
import org.eclipse.jface.text.hyperlink.IHyperlink;
import org.eclipse.jface.text.hyperlink.IHyperlinkDetector;
import org.eclipse.jface.text.source.ISourceViewer;
import org.eclipse.jface.text.source.SourceViewerConfiguration;
import org.eclipse.jface.text.source.projection.ProjectionAnnotationModel;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.widgets.Button;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Table;
import org.eclipse.swt.widgets.Text;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.editors.text.TextEditor;
import org.eclipse.ui.handlers.IHandlerService;
import org.eclipse.ui.texteditor.AbstractTextEditor;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests that the editors of texts say what the analysis of the engine says. */
class CodeQuestionsTest {

  private static final String COMMANDS = "dev.eventchain.eclipse.ui.text.";

  private static final String RULES =
      """
      context SoftwareNode
        def: isFast() : Boolean = self.frequency > 20
        inv Fast: isFast() or self.name <> 'slow'
        inv Later: not isFast() implies self.nextstep->notEmpty()
      """;

  private static final String BASE =
      """
      [module base('http://eventchain.dev/eventchain/1.0')]
      [template public line(node : SoftwareNode)]
      [node.name/]
      [/template]
      """;

  private static final String MAIN =
      """
      [module main('http://eventchain.dev/eventchain/1.0')]
      [import base/]
      [template public all(chain : EventChain)]
      [for (node | chain.software)]
      [line(node)/]
      [/for]
      [/template]
      """;

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

  private static IDocument document(TextEditor editor) {
    return editor.getDocumentProvider().getDocument(editor.getEditorInput());
  }

  private static ISourceViewer viewer(TextEditor editor) {
    return (ISourceViewer) editor.getAdapter(ITextViewer.class);
  }

  /** Returns the configuration that the platform asks, too. */
  private static SourceViewerConfiguration configuration(TextEditor editor) throws Exception {
    var method = AbstractTextEditor.class.getDeclaredMethod("getSourceViewerConfiguration");
    method.setAccessible(true);
    return (SourceViewerConfiguration) method.invoke(editor);
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

  private static StyledText widget(TextEditor editor) {
    return (StyledText) editor.getAdapter(Control.class);
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
  void linksLeadToDeclarationsInOtherFiles() throws Exception {
    project.write("base.mtl", BASE);
    TextEditor editor = Workbench.open(project.write("main.mtl", MAIN));
    IHyperlinkDetector links = configuration(editor).getHyperlinkDetectors(viewer(editor))[0];
    Region call = new Region(MAIN.indexOf("line(node)"), 0);
    Workbench.waitUntil("a link", () -> links(links, editor, call) != null);
    assertEquals(
        null, Workbench.run(() -> links(links, editor, new Region(MAIN.indexOf("for"), 0))));
    Workbench.run(
        () -> {
          links(links, editor, call)[0].open();
          return editor;
        });
    Workbench.waitUntil("base.mtl", () -> Workbench.page().getActiveEditor() != editor);
    IEditorPart opened = Workbench.run(() -> Workbench.page().getActiveEditor());
    assertEquals("base.mtl", opened.getTitle());
    assertEquals("line", Workbench.run(() -> widget((TextEditor) opened).getSelectionText()));
  }

  private static IHyperlink[] links(IHyperlinkDetector links, TextEditor editor, Region region) {
    return links.detectHyperlinks(viewer(editor), region, false);
  }

  @Test
  void keyOpensTheDeclaration() throws Exception {
    TextEditor editor = Workbench.open(project.write("rules.ocl", RULES));
    execute(editor, "openDeclaration", RULES.lastIndexOf("isFast"));
    Workbench.waitUntil(
        "the declaration is selected",
        () ->
            widget(editor).getSelectionText().equals("isFast")
                && widget(editor).getSelection().x == RULES.indexOf("isFast"));
  }

  private static void execute(TextEditor editor, String command, int offset) {
    Workbench.run(
        () -> {
          Workbench.page().activate(editor);
          editor.selectAndReveal(offset, 0);
          return PlatformUI.getWorkbench()
              .getService(IHandlerService.class)
              .executeCommand(COMMANDS + command, null);
        });
  }

  @Test
  void referencesAreListed() throws Exception {
    project.write("base.mtl", BASE);
    TextEditor editor = Workbench.open(project.write("main.mtl", MAIN));
    execute(editor, "findReferences", MAIN.indexOf("line(node)"));
    List<String> listed = rows("References");
    assertEquals(
        List.of(
            "base.mtl:2: [template public line(node : SoftwareNode)]", "main.mtl:5: [line(node)/]"),
        listed);
    Workbench.screenshot("text-references");
    press("References", "Cancel");
  }

  @Test
  void renamingIsShownAndThenChangesAllFiles() throws Exception {
    project.write("base.mtl", BASE);
    TextEditor editor = Workbench.open(project.write("main.mtl", MAIN));
    Workbench.run(
        () -> {
          document(editor).replace(MAIN.length(), 0, "Unsaved.\n");
          return editor;
        });
    execute(editor, "rename", MAIN.indexOf("line(node)"));
    Workbench.waitUntil("the question", () -> find(shell("Rename"), Text.class).isPresent());
    Workbench.run(
        () -> {
          find(shell("Rename"), Text.class).orElseThrow().setText("entry");
          return editor;
        });
    press("Rename", "OK");
    assertEquals(2, rows("Rename").size());
    Workbench.screenshot("text-rename");
    press("Rename", "OK");
    String renamed = (MAIN + "Unsaved.\n").replace("line(node)", "entry(node)");
    Workbench.waitUntil("the new name", () -> document(editor).get().equals(renamed));
    Workbench.waitFor(() -> textOf("base.mtl").contains("public entry("), () -> "it is saved");
    assertTrue(Workbench.run(editor::isDirty));
    assertEquals(MAIN, project.text("main.mtl"));
  }

  private String textOf(String name) {
    try {
      return project.text(name);
    } catch (java.io.IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  @Test
  void renamingToAWordOfTheLanguageIsRefused() throws Exception {
    TextEditor editor = Workbench.open(project.write("rules.ocl", RULES));
    execute(editor, "rename", RULES.indexOf("isFast"));
    Workbench.waitUntil("the question", () -> find(shell("Rename"), Text.class).isPresent());
    Workbench.run(
        () -> {
          find(shell("Rename"), Text.class).orElseThrow().setText("then");
          return editor;
        });
    press("Rename", "OK");
    Workbench.waitUntil(
        "the reason",
        () -> shell("Rename").isPresent() && find(shell("Rename"), Text.class).isEmpty());
    press("Rename", "OK");
    assertEquals(RULES, Workbench.run(() -> document(editor).get()));
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

  private static Optional<Shell> shell(String title) {
    return Arrays.stream(Display.getCurrent().getShells())
        .filter(each -> each.isVisible() && each.getText().equals(title))
        .reduce((first, second) -> second);
  }

  private static List<String> rows(String title) {
    Workbench.waitUntil("a list", () -> find(shell(title), Table.class).isPresent());
    return Workbench.run(
        () ->
            Arrays.stream(find(shell(title), Table.class).orElseThrow().getItems())
                .map(item -> item.getText())
                .toList());
  }

  private static void press(String title, String label) {
    Workbench.run(
        () -> {
          Button button =
              buttons(shell(title).orElseThrow())
                  .filter(each -> each.getText().replace("&", "").equals(label))
                  .findFirst()
                  .orElseThrow();
          assertTrue(button.isEnabled(), label);
          Display.getCurrent().asyncExec(() -> button.notifyListeners(SWT.Selection, null));
          return button;
        });
  }

  private static java.util.stream.Stream<Button> buttons(Composite parent) {
    return all(parent).filter(Button.class::isInstance).map(Button.class::cast);
  }

  private static <T> Optional<T> find(Optional<Shell> shell, Class<T> type) {
    return shell.flatMap(
        each ->
            all(each)
                .filter(type::isInstance)
                .map(type::cast)
                .filter(one -> !(one instanceof Text text) || text.getEditable())
                .findFirst());
  }

  private static java.util.stream.Stream<Control> all(Composite parent) {
    return Arrays.stream(parent.getChildren())
        .flatMap(
            each ->
                each instanceof Composite inner && !(each instanceof Table)
                    ? java.util.stream.Stream.concat(java.util.stream.Stream.of(each), all(inner))
                    : java.util.stream.Stream.of(each));
  }
}
