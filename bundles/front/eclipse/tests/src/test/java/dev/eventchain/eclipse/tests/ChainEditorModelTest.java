package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.messages.Unit;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IFolder;
import org.eclipse.core.resources.IMarker;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.jface.viewers.IStructuredSelection;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Table;
import org.eclipse.swt.widgets.TableItem;
import org.eclipse.swt.widgets.Text;
import org.eclipse.swt.widgets.Tree;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IWorkbenchCommandConstants;
import org.eclipse.ui.dialogs.FilteredTree;
import org.eclipse.ui.forms.widgets.Form;
import org.eclipse.ui.ide.IDE;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the editor's model of the chain: structure, findings and content proposals. */
class ChainEditorModelTest {

  private EditorBench bench;
  private IFile file;
  private byte[] bytes;
  private IEditorPart editor;
  private EventChain chain;

  @BeforeEach
  void open() {
    Workbench.require();
    bench = new EditorBench("chain-model");
    bytes = XmiStore.toBytes(EditorBench.chain());
    file = bench.file("chain.xmi", bytes);
    editor = EditorBench.open(file);
    chain = EditorBench.chainOf(editor);
  }

  @AfterEach
  void close() {
    if (bench != null) {
      bench.close();
    }
  }

  /** Returns the tree of the editor, which has a filter, unlike that of the Outline. */
  private static Tree tree() {
    return EditorBench.find(Tree.class, ChainEditorModelTest::hasFilter);
  }

  private static boolean hasFilter(Control tree) {
    for (Composite up = tree.getParent(); up != null; up = up.getParent()) {
      if (up instanceof FilteredTree) {
        return true;
      }
    }
    return false;
  }

  private void inTree(String command) {
    Workbench.run(() -> tree().setFocus());
    Workbench.waitUntil("the tree has the focus", () -> tree().isFocusControl());
    EditorBench.command(command);
  }

  private static Image image() {
    return tree().getItem(0).getItem(1).getImage();
  }

  private static String message() {
    return message("aeb");
  }

  private static String message(String title) {
    Form form = EditorBench.find(Form.class, any -> any.getText().equals(title));
    return form.getMessage() == null ? "" : form.getMessage();
  }

  @Test
  void deletesWithAllReferences() {
    SoftwareNode first = chain.getSoftware().get(0);
    SoftwareNode second = chain.getSoftware().get(1);
    EditorBench.select(editor, second);
    inTree(IWorkbenchCommandConstants.EDIT_DELETE);
    assertEquals(List.of(first), chain.getSoftware());
    assertNull(first.getNextstep());
    assertNull(chain.getLatencyConstraints().get(0).getLast());
    assertEquals(2, chain.getData().size(), "the data of the component go, too");
    EditorBench.command(IWorkbenchCommandConstants.EDIT_UNDO);
    assertArrayEquals(bytes, EditorBench.bytesOf(editor));
  }

  @Test
  void copiesAComponentWithItsData() {
    EditorBench.select(editor, chain.getSoftware().get(1));
    inTree(IWorkbenchCommandConstants.EDIT_COPY);
    EditorBench.select(editor, chain);
    inTree(IWorkbenchCommandConstants.EDIT_PASTE);
    SoftwareNode copy = chain.getSoftware().get(2);
    assertEquals("Braking_Decision_2", copy.getName());
    assertEquals(6, chain.getData().size());
    assertSame(chain, copy.getInput().get(0).eContainer());
    assertEquals(chain.getRequirements(), copy.getSatisfies());
    EditorBench.command(IWorkbenchCommandConstants.EDIT_UNDO);
    assertArrayEquals(bytes, EditorBench.bytesOf(editor));
  }

  @Test
  void makesAndMovesElements() {
    SoftwareNode first = chain.getSoftware().get(0);
    EditorBench.select(editor, first);
    choose("New", "Input");
    Data made = (Data) selected();
    assertEquals("value_1", made.getName());
    assertEquals(made, first.getInput().get(1));
    assertSame(chain, made.eContainer());
    choose("Move Up");
    assertEquals(made, first.getInput().get(0));
    choose("New", "Quality of service");
    assertSame(made.getQos(), selected());
    EditorBench.select(editor, first);
    choose("New", "Requirement");
    assertEquals("REQ-1", chain.getRequirements().get(1).getId());
    for (int i = 0; i < 4; i++) {
      EditorBench.command(IWorkbenchCommandConstants.EDIT_UNDO);
    }
    assertArrayEquals(bytes, EditorBench.bytesOf(editor));
  }

  private static void choose(String... texts) {
    Workbench.run(
        () -> {
          EditorBench.choose(tree(), texts);
          return texts;
        });
  }

  @Test
  void copiesTextAndNotElementsWhileAFieldHasTheFocus() {
    EditorBench.select(editor, chain.getSoftware().get(1));
    inTree(IWorkbenchCommandConstants.EDIT_COPY);
    Workbench.run(
        () -> {
          Text name = EditorBench.field(Text.class, "name");
          name.setFocus();
          name.setText("x");
          name.selectAll();
          return name;
        });
    Workbench.waitUntil(
        "the field has the focus", () -> EditorBench.field(Text.class, "name").isFocusControl());
    EditorBench.command(IWorkbenchCommandConstants.EDIT_CUT);
    assertEquals("", EditorBench.typed("name"));
    EditorBench.command(IWorkbenchCommandConstants.EDIT_PASTE);
    assertEquals("x", EditorBench.typed("name"));
    assertEquals(2, chain.getSoftware().size());
  }

  @Test
  void showsFindingsWhileTheyHold() {
    Workbench.waitUntil("the chain was checked", () -> !message().isEmpty());
    String before = Workbench.run(ChainEditorModelTest::message);
    Image sound = Workbench.run(ChainEditorModelTest::image);
    EditorBench.select(editor, chain.getSoftware().get(1));
    EditorBench.type("name", "2 be");
    Workbench.waitUntil("the finding is shown", () -> image() != sound);
    assertTrue(!before.equals(Workbench.run(ChainEditorModelTest::message)));
    Workbench.screenshot("editor-finding");
    EditorBench.command(IWorkbenchCommandConstants.EDIT_UNDO);
    Workbench.waitUntil("the finding is gone", () -> image() == sound);
    assertEquals(before, Workbench.run(ChainEditorModelTest::message));
  }

  @Test
  void proposesWhatMayStandInAField() {
    Workbench.waitUntil("the message types are known", () -> !message().isEmpty());
    EditorBench.select(editor, chain.getData().get(0));
    assertTrue(proposals("fieldName", "stamp").contains("header.stamp.sec"));
    assertTrue(proposals("messageType", "LaserS").contains("sensor_msgs/msg/LaserScan"));
    assertEquals(List.of("/ttc"), proposals("topicName", "tt"));
    List<String> units = proposals("unit", "");
    assertTrue(units.contains("km/h"));
    assertEquals(List.of(), units.stream().filter(unit -> Unit.parse(unit).isEmpty()).toList());
  }

  private static List<String> proposals(String feature, String typed) {
    Workbench.run(
        () -> {
          Text text = EditorBench.field(Text.class, feature);
          text.setFocus();
          text.setText(typed);
          text.setSelection(typed.length());
          Event key = new Event();
          key.keyCode = ' ';
          key.character = ' ';
          key.stateMask = SWT.CTRL;
          text.notifyListeners(SWT.KeyDown, key);
          return text;
        });
    Workbench.waitUntil("proposals for " + feature, () -> proposals() != null);
    List<String> texts =
        Workbench.run(() -> Arrays.stream(proposals().getItems()).map(TableItem::getText).toList());
    Workbench.screenshot("editor-proposals-" + feature);
    Workbench.run(
        () -> {
          proposals().getShell().close();
          return feature;
        });
    return texts;
  }

  /** Returns the open list over the window, whose items are filled when shown. */
  private static Table proposals() {
    Shell window = Workbench.page().getWorkbenchWindow().getShell();
    return EditorBench.find(
        Table.class,
        table -> table.getShell() != window && table.getItemCount() > 0 && table.isVisible());
  }

  @Test
  void goesToWhatAMarkerIsAbout() {
    go("EventChain[aeb]/software[Braking_Decision]", 0);
    assertSame(chain.getSoftware().get(1), selected());
    go("EventChain[aeb]/data[gone]", 0);
    assertSame(chain, selected());
    go("", 5);
    assertSame(chain.getData().get(0), selected());
  }

  private void go(String element, int line) {
    Workbench.run(
        () -> {
          IMarker marker = file.createMarker(IMarker.PROBLEM);
          marker.setAttribute("element", element);
          marker.setAttribute(IMarker.LINE_NUMBER, line);
          IDE.gotoMarker(editor, marker);
          return marker;
        });
  }

  private EObject selected() {
    return Workbench.run(
        () ->
            (EObject)
                ((IStructuredSelection) editor.getSite().getSelectionProvider().getSelection())
                    .getFirstElement());
  }

  /** A chain from the command line, with message types of its own. */
  @Test
  void editsTheChainOfAProject() throws IOException {
    Path example = Path.of("..", "..", "..", "..", "examples", "radar-aeb");
    IFolder folder = bench.project().getFolder("software-base");
    URI base = example.resolve("software-base").toRealPath().toUri();
    EditorBench.work(() -> folder.createLink(base, 0, null));
    byte[] written = Files.readAllBytes(example.resolve("model").resolve("chain.xmi"));
    file = bench.file("radar.xmi", written);
    editor = EditorBench.open(file);
    chain = EditorBench.chainOf(editor);
    Data distance = chain.getData().get(1);
    EditorBench.select(editor, distance);
    EditorBench.type("unit", "x");
    EditorBench.save(editor);
    EditorBench.type("unit", "m");
    EditorBench.save(editor);
    assertArrayEquals(written, EditorBench.bytes(file));
    EditorBench.type("fieldName", "range");
    Workbench.waitUntil("the message types are read", () -> !message("radar_aeb").isEmpty());
    Workbench.screenshot("editor-radar");
    assertEquals(List.of("range", "range_rate"), proposals("fieldName", "range"));
  }

  @Test
  void showsEachKindOfElement() {
    Workbench.waitUntil("the chain was checked", () -> !message().isEmpty());
    List<EObject> elements =
        List.of(
            chain,
            chain.getSoftware().get(1),
            chain.getData().get(1),
            chain.getData().get(1).getQos(),
            chain.getRequirements().get(0),
            chain.getLatencyConstraints().get(0));
    for (EObject element : elements) {
      EditorBench.select(editor, element);
      assertSame(element, selected());
      Workbench.screenshot("editor-" + element.eClass().getName());
    }
    assertArrayEquals(bytes, EditorBench.bytesOf(editor), "to look at a chain does not change it");
  }
}
