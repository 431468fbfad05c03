package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.ITextOperationTarget;
import org.eclipse.jface.text.source.Annotation;
import org.eclipse.jface.text.source.IAnnotationModel;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StyleRange;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Table;
import org.eclipse.swt.widgets.Tree;
import org.eclipse.swt.widgets.TreeItem;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.editors.text.TextEditor;
import org.eclipse.ui.handlers.IHandlerService;
import org.eclipse.ui.texteditor.ITextEditor;
import org.eclipse.ui.views.contentoutline.ContentOutline;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests editing of constraints and templates in the workbench. */
class CodeEditorTest {

  private static final String COLORS = "dev.eventchain.eclipse.ui.text.";

  private static final String RULES =
      """
      -- Nodes have a rate.
      context SoftwareNode
        inv HasRate: self.frequency > 0.5 and self.name <> 'none'

      /* Names are
         unique. */
      context EventChain
        inv UniqueNames: self.software->isUnique(name)
      """;

  private static final String TEMPLATE =
      """
      [comment encoding = UTF-8 /]
      [module node('http://eventchain.dev/eventchain/1.0')]

      [** One file for each chain. */]
      [template public node(chain : EventChain)]
      [file (chain.name + '.txt')]
      Nodes of [chain.name/], if any:
      [for (node : SoftwareNode | chain.software) separator ('\\n')]
        [node.name.toUpper()/]: [if node.frequency > 20 then 'fast' else 'slow' endif/]
      [/for]
      [/file]
      [/template]
      """;

  private TestProject project;

  @BeforeEach
  void create() throws Exception {
    Workbench.require();
    project = TestProject.create("texts");
  }

  @AfterEach
  void close() throws Exception {
    Workbench.close(project);
  }

  private static StyledText widget(TextEditor editor) {
    return (StyledText) editor.getAdapter(Control.class);
  }

  private static IDocument document(ITextEditor editor) {
    return editor.getDocumentProvider().getDocument(editor.getEditorInput());
  }

  private static RGB color(String kind) {
    return PlatformUI.getWorkbench()
        .getThemeManager()
        .getCurrentTheme()
        .getColorRegistry()
        .getRGB(COLORS + kind);
  }

  private static void assertColor(String kind, TextEditor editor, String text) {
    RGB expected = Workbench.run(() -> color(kind));
    assertNotNull(expected, kind);
    Workbench.waitUntil(
        text + " is drawn as " + kind,
        () -> {
          int offset = document(editor).get().indexOf(text);
          StyleRange range = widget(editor).getStyleRangeAtOffset(offset);
          return range != null
              && range.foreground != null
              && range.foreground.getRGB().equals(expected);
        });
  }

  private static void assertPlain(TextEditor editor, String text) {
    StyleRange range =
        Workbench.run(
            () -> widget(editor).getStyleRangeAtOffset(document(editor).get().indexOf(text)));
    assertTrue(range == null || range.foreground == null, text);
  }

  @Test
  void constraintsHaveColors() throws Exception {
    TextEditor editor = Workbench.open(project.write("rules.ocl", RULES));
    assertColor("comment", editor, "Nodes have");
    assertColor("keyword", editor, "context");
    assertColor("type", editor, "SoftwareNode");
    assertColor("number", editor, "0.5");
    assertColor("string", editor, "none");
    assertColor("comment", editor, "unique. */");
    assertPlain(editor, "frequency");
    Workbench.run(
        () -> {
          document(editor).replace(RULES.indexOf("*/"), 2, "");
          return editor;
        });
    assertColor("comment", editor, "EventChain");
    Workbench.screenshot("text-ocl");
  }

  @Test
  void templatesHaveColors() throws Exception {
    TextEditor editor = Workbench.open(project.write("node.mtl", TEMPLATE));
    assertColor("comment", editor, "encoding");
    assertColor("tag", editor, "[template");
    assertColor("type", editor, "EventChain)");
    assertColor("keyword", editor, "public");
    assertColor("string", editor, ".txt");
    assertColor("tag", editor, "/], if");
    assertPlain(editor, "if any");
    assertColor("keyword", editor, "then");
    assertColor("tag", editor, "[/for");
    Workbench.screenshot("text-mtl");
  }

  @Test
  void linesBecomeCommentsAndBack() throws Exception {
    TextEditor rules = Workbench.open(project.write("rules.ocl", RULES));
    toggle(rules, RULES.indexOf("  inv HasRate"), 0);
    String commented = RULES.replace("  inv HasRate", "--   inv HasRate");
    assertEquals(commented, Workbench.run(() -> document(rules).get()));
    toggle(rules, RULES.indexOf("inv HasRate"), 0);
    assertEquals(RULES, Workbench.run(() -> document(rules).get()));
    TextEditor template = Workbench.open(project.write("node.mtl", TEMPLATE));
    String loop = TEMPLATE.substring(TEMPLATE.indexOf("[for"), TEMPLATE.indexOf("[/file"));
    toggle(template, TEMPLATE.indexOf(loop), loop.length());
    String line = loop.stripTrailing();
    String without = TEMPLATE.replace(line, "[comment]" + line + "[/comment]");
    assertEquals(without, Workbench.run(() -> document(template).get()));
    assertColor("comment", template, "toUpper");
  }

  private static void toggle(TextEditor editor, int offset, int length) {
    Workbench.run(
        () -> {
          Workbench.page().activate(editor);
          editor.selectAndReveal(offset, length);
          IHandlerService handlers = PlatformUI.getWorkbench().getService(IHandlerService.class);
          return handlers.executeCommand(COLORS + "toggleComment", null);
        });
  }

  @Test
  void featuresOfTheContextAreProposed() throws Exception {
    TextEditor editor = Workbench.open(project.write("rules.ocl", RULES));
    List<String> features = proposals(editor, RULES.indexOf("frequency"));
    assertTrue(features.containsAll(List.of("frequency", "name", "nextstep")), "" + features);
    assertTrue(!features.contains("software"), "" + features);
    List<String> started = proposals(editor, RULES.indexOf("software->") + "soft".length());
    assertEquals(List.of("software"), started);
    List<String> classes = proposals(editor, RULES.indexOf("EventChain") + "Event".length());
    assertTrue(classes.contains("EventChain"), "" + classes);
  }

  @Test
  void classesOfTheProjectAreProposed() throws Exception {
    project.write(
        "shop.ecore",
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI"
            xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
            xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" name="shop" nsURI="urn:shop" nsPrefix="shop">
          <eClassifiers xsi:type="ecore:EClass" name="Shop">
            <eStructuralFeatures xsi:type="ecore:EAttribute" name="owner"
                eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EString"/>
          </eClassifiers>
        </ecore:EPackage>
        """);
    String text =
        "[module m('urn:shop')]\n[template public t(s : Shop)]\n[s.owner/]\n[/template]\n";
    TextEditor editor = Workbench.open(project.write("shop.mtl", text));
    assertColor("type", editor, "Shop");
    assertEquals("owner", proposals(editor, text.indexOf("owner")).get(0));
    List<String> blocks = proposals(editor, text.indexOf("template") + 1);
    assertTrue(blocks.contains("template"), "" + blocks);
  }

  /** Returns the entries of the proposal pop-up, and closes it. */
  private static List<String> proposals(TextEditor editor, int offset) {
    Workbench.run(
        () -> {
          Workbench.page().activate(editor);
          editor.selectAndReveal(offset, 0);
          editor
              .getAdapter(ITextOperationTarget.class)
              .doOperation(org.eclipse.jface.text.source.ISourceViewer.CONTENTASSIST_PROPOSALS);
          return editor;
        });
    List<String> listed = new ArrayList<>();
    Workbench.waitUntil(
        "proposals, or the only one inserted",
        () -> {
          String now = document(editor).get();
          listed.clear();
          popup().ifPresent(table -> listed.addAll(texts(table)));
          listed.removeIf(each -> each.startsWith("Computing proposals"));
          return !listed.isEmpty() || !now.isEmpty() && editor.isDirty();
        });
    return Workbench.run(
        () -> {
          if (listed.isEmpty()) {
            throw new AssertionError("a proposal was inserted");
          }
          popup().ifPresent(table -> table.getShell().close());
          return List.copyOf(listed);
        });
  }

  private static java.util.Optional<Table> popup() {
    for (Shell shell : Display.getCurrent().getShells()) {
      if (shell.isVisible() && shell.getText().isEmpty()) {
        for (Control child : shell.getChildren()) {
          if (child instanceof Table table) {
            return java.util.Optional.of(table);
          }
        }
      }
    }
    return java.util.Optional.empty();
  }

  private static List<String> texts(Table table) {
    List<String> texts = new ArrayList<>();
    for (int i = 0; i < table.getItemCount(); i++) {
      table.setSelection(i); // a virtual table fetches shown items only
      texts.add(table.getItem(i).getText().replaceFirst("  .*", "")); // without the type
    }
    return texts;
  }

  @Test
  void brokenFileIsAnnotatedAfterItIsSaved() throws Exception {
    TextEditor editor = Workbench.open(project.write("rules.ocl", RULES));
    project.build();
    assertEquals(List.of(), project.markers());
    Workbench.run(
        () -> {
          document(editor).replace(RULES.indexOf("frequency"), 9, "frequenzy");
          editor.doSave(null);
          return editor;
        });
    project.build();
    assertEquals(1, project.found().length, "" + project.markers());
    Workbench.waitUntil("an annotation", () -> errors(editor).size() == 1);
    assertTrue(errors(editor).get(0).contains("frequenzy"), "" + errors(editor));
  }

  private static List<String> errors(TextEditor editor) {
    IAnnotationModel model =
        editor.getDocumentProvider().getAnnotationModel(editor.getEditorInput());
    List<String> errors = new ArrayList<>();
    for (Iterator<Annotation> all = model.getAnnotationIterator(); all.hasNext(); ) {
      Annotation each = all.next();
      if ("org.eclipse.ui.workbench.texteditor.error".equals(each.getType())) {
        errors.add(each.getText());
      }
    }
    return errors;
  }

  @Test
  void outlineListsWhatIsDeclared() throws Exception {
    TextEditor editor = Workbench.open(project.write("rules.ocl", RULES));
    ContentOutline outline = outline();
    Workbench.run(
        () -> {
          Workbench.page().activate(editor);
          return editor;
        });
    waitForOutline(outline, "SoftwareNode", "HasRate", "EventChain", "UniqueNames");
    Workbench.run(
        () -> {
          document(editor).set(RULES.replace("software->isUnique(name)", "software->isUn"));
          document(editor).replace(0, 0, "context SoftwareNode inv Fast: self.\n");
          return editor;
        });
    waitForOutline(
        outline, "SoftwareNode", "Fast", "SoftwareNode", "HasRate", "EventChain", "UniqueNames");
  }

  private static ContentOutline outline() {
    return Workbench.run(
        () -> (ContentOutline) Workbench.page().showView("org.eclipse.ui.views.ContentOutline"));
  }

  /** Waits until these names are shown, in this order. */
  private static void waitForOutline(ContentOutline outline, String... names) {
    Workbench.waitUntil(
        "an outline of " + List.of(names),
        () -> {
          List<String> shown = new ArrayList<>();
          collect(((Tree) tree(outline)).getItems(), shown);
          return shown.equals(List.of(names));
        });
  }

  private static void collect(TreeItem[] items, List<String> names) {
    for (TreeItem item : items) {
      names.add(item.getText().replaceFirst("^(context|inv) ", "").replaceFirst(" .*", ""));
      collect(item.getItems(), names);
    }
  }

  @Test
  void clickInTheOutlineGoesThere() throws Exception {
    TextEditor editor = Workbench.open(project.write("rules.ocl", RULES));
    ContentOutline outline = outline();
    Workbench.run(
        () -> {
          Workbench.page().activate(editor);
          Workbench.page().activate(outline);
          return tree(outline).setFocus();
        });
    Workbench.waitUntil("the outline has the focus", () -> tree(outline).isFocusControl());
    waitForOutline(outline, "SoftwareNode", "HasRate", "EventChain", "UniqueNames");
    Workbench.run(
        () -> {
          Tree tree = (Tree) tree(outline);
          TreeItem rule = tree.getItem(1).getItem(0);
          tree.setSelection(rule);
          Event click = new Event();
          click.item = rule;
          tree.notifyListeners(SWT.Selection, click);
          return tree;
        });
    assertEquals("UniqueNames", Workbench.run(() -> widget(editor).getSelectionText()));
  }

  /** WCAG asks for three to one where letters are bold or large; the dark ground is Eclipse's. */
  @Test
  void colorsCanBeReadOnLightAndDarkGrounds() {
    for (String kind : List.of("keyword", "type", "string", "number", "comment", "tag")) {
      RGB color = Workbench.run(() -> color(kind));
      for (RGB ground : List.of(new RGB(255, 255, 255), new RGB(47, 47, 47))) {
        double one = luminance(color) + 0.05;
        double other = luminance(ground) + 0.05;
        double contrast = Math.max(one, other) / Math.min(one, other);
        assertTrue(contrast >= 3, kind + " on " + ground + ": " + contrast);
      }
    }
  }

  private static double luminance(RGB color) {
    return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
  }

  private static double linear(int part) {
    double value = part / 255.0;
    return value <= 0.03928 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4);
  }

  private static Control tree(ContentOutline outline) {
    return outline.getCurrentPage().getControl();
  }
}
