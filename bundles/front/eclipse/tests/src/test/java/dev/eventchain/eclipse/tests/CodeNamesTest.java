package dev.eventchain.eclipse.tests;

import static dev.eventchain.eclipse.tests.TextEditors.MAIN;
import static dev.eventchain.eclipse.tests.TextEditors.RULES;
import static dev.eventchain.eclipse.tests.TextEditors.configuration;
import static dev.eventchain.eclipse.tests.TextEditors.document;
import static dev.eventchain.eclipse.tests.TextEditors.viewer;
import static dev.eventchain.eclipse.tests.TextEditors.widget;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.jface.text.Region;
import org.eclipse.jface.text.hyperlink.IHyperlink;
import org.eclipse.jface.text.hyperlink.IHyperlinkDetector;
import org.eclipse.swt.SWT;
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
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests of what editors of texts do with a name: its declaration, its uses, and another name. */
class CodeNamesTest {

  private static final String COMMANDS = "dev.eventchain.eclipse.ui.text.";

  private static final String BASE =
      """
      [module base('http://eventchain.dev/eventchain/1.0')]
      [template public line(node : SoftwareNode)]
      [node.name/]
      [/template]
      """;

  private TestProject project;

  @BeforeEach
  void create() throws Exception {
    Workbench.require();
    project = TestProject.create("names");
  }

  @AfterEach
  void close() throws Exception {
    Workbench.close(project);
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
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The changes were found for another text: no file is changed, not even those that fit. */
  @Test
  void nothingIsRenamedIfAFileHasChangedMeanwhile() throws Exception {
    project.write("base.mtl", BASE);
    TextEditor editor = Workbench.open(project.write("main.mtl", MAIN));
    execute(editor, "rename", MAIN.indexOf("line(node)"));
    Workbench.waitUntil("the question", () -> find(shell("Rename"), Text.class).isPresent());
    Workbench.run(
        () -> {
          find(shell("Rename"), Text.class).orElseThrow().setText("entry");
          return editor;
        });
    press("Rename", "OK");
    assertEquals(2, rows("Rename").size());
    project.write("base.mtl", BASE + "\n");
    press("Rename", "OK");
    Workbench.waitUntil(
        "the reason",
        () -> shell("Rename").isPresent() && find(shell("Rename"), Table.class).isEmpty());
    press("Rename", "OK");
    assertEquals(MAIN, Workbench.run(() -> document(editor).get()));
    assertFalse(Workbench.run(editor::isDirty));
    assertEquals(BASE + "\n", project.text("base.mtl"));
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

  private static Stream<Button> buttons(Composite parent) {
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

  private static Stream<Control> all(Composite parent) {
    return Arrays.stream(parent.getChildren())
        .flatMap(
            each ->
                each instanceof Composite inner && !(each instanceof Table)
                    ? Stream.concat(Stream.of(each), all(inner))
                    : Stream.of(each));
  }
}
