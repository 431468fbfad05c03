package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.xmi.XmiStore;
import java.nio.charset.StandardCharsets;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.ResourceAttributes;
import org.eclipse.swt.widgets.Table;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IWorkbenchCommandConstants;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests an editor whose file was changed, moved or deleted. */
class ChainEditorFilesTest {

  private EditorBench bench;
  private IFile file;
  private byte[] bytes;
  private IEditorPart editor;

  @BeforeEach
  void open() {
    Workbench.require();
    bench = new EditorBench("chain-files");
    bytes = XmiStore.toBytes(EditorBench.chain());
    file = bench.file("chain.xmi", bytes);
    editor = EditorBench.open(file);
  }

  @AfterEach
  void close() {
    if (bench != null) {
      bench.close();
    }
  }

  private byte[] renamed(String name) {
    EventChain chain = EditorBench.chain();
    chain.setName(name);
    return XmiStore.toBytes(chain);
  }

  private boolean isShown(String name) {
    EventChain chain = editor.getAdapter(EventChain.class);
    return chain != null && name.equals(chain.getName());
  }

  private void rename(String name) {
    EditorBench.select(editor, EditorBench.chainOf(editor));
    EditorBench.type("name", name);
  }

  @Test
  void showsWhatIsWrongWithAFileUntilItIsMended() {
    String broken =
        new String(bytes, StandardCharsets.UTF_8).replace("//@software.1", "//@software.7");
    bench.file("chain.xmi", broken);
    Workbench.waitUntil(
        "the broken file is shown", () -> editor.getAdapter(EventChain.class) == null);
    assertTrue(
        Workbench.run(
            () -> {
              Table table = EditorBench.find(Table.class, any -> any.getHeaderVisible());
              return table.getItem(0).getText(0).matches("\\d+")
                  && table.getItem(0).getText(1).contains("//@software.7");
            }));
    assertFalse(Workbench.run(editor::isDirty));
    Workbench.screenshot("editor-broken");
    Workbench.run(
        () -> {
          EditorBench.click(EditorBench.button("Open as text"));
          return file;
        });
    assertEquals(
        "org.eclipse.ui.DefaultTextEditor",
        Workbench.run(() -> Workbench.page().getActiveEditor().getSite().getId()));
    bench.file("chain.xmi", bytes);
    Workbench.waitUntil("the fixed file is shown", () -> isShown("aeb"));
  }

  @Test
  void opensAFileThatIsBroken() {
    IFile broken = bench.file("broken.eventchain", "<EventChain");
    IEditorPart on = EditorBench.open(broken);
    assertEquals(EditorBench.EDITOR, Workbench.run(() -> on.getSite().getId()));
    assertNotNull(Workbench.run(() -> EditorBench.button("Open as text")));
  }

  @Test
  void takesOverChangesWhileItHasNone() {
    bench.file("chain.xmi", renamed("other"));
    Workbench.waitUntil("the other chain is shown", () -> isShown("other"));
    assertFalse(Workbench.run(editor::isDirty));
  }

  @Test
  void asksWhichChangesAreToStay() {
    rename("mine");
    bench.file("chain.xmi", renamed("theirs"));
    EditorBench.press("Keep my changes");
    assertTrue(Workbench.run(() -> isShown("mine") && editor.isDirty()));
    bench.file("chain.xmi", renamed("theirs2"));
    EditorBench.press("Load the file");
    Workbench.waitUntil("their chain is shown", () -> isShown("theirs2"));
    assertFalse(Workbench.run(editor::isDirty));
  }

  @Test
  void reverts() {
    rename("mine");
    EditorBench.command(IWorkbenchCommandConstants.FILE_REVERT);
    assertTrue(Workbench.run(() -> isShown("aeb") && !editor.isDirty()));
  }

  @Test
  void writesADeletedFileAgain() {
    EditorBench.work(() -> file.delete(true, null));
    Workbench.waitUntil("there is something to save", editor::isDirty);
    Workbench.screenshot("editor-deleted");
    EditorBench.save(editor);
    assertArrayEquals(bytes, EditorBench.bytes(file));
    assertFalse(Workbench.run(editor::isDirty));
  }

  @Test
  void followsAFileThatIsRenamed() {
    rename("mine");
    EditorBench.work(
        () -> file.move(file.getFullPath().removeLastSegments(1).append("b.xmi"), true, null));
    Workbench.waitUntil("the new name is shown", () -> editor.getTitle().equals("b.xmi"));
    EditorBench.save(editor);
    assertArrayEquals(renamed("mine"), EditorBench.bytes(bench.project().getFile("b.xmi")));
  }

  @Test
  void saysWhatToDoAboutAReadOnlyFile() {
    setReadOnly(true);
    rename("mine");
    Workbench.display().asyncExec(() -> Workbench.page().saveEditor(editor, false));
    EditorBench.press("No");
    EditorBench.press("Cancel");
    assertArrayEquals(bytes, EditorBench.bytes(file));
    assertTrue(Workbench.run(editor::isDirty));
    setReadOnly(false);
    EditorBench.save(editor);
    assertArrayEquals(renamed("mine"), EditorBench.bytes(file));
  }

  private void setReadOnly(boolean value) {
    ResourceAttributes attributes = file.getResourceAttributes();
    attributes.setReadOnly(value);
    EditorBench.work(() -> file.setResourceAttributes(attributes));
  }

  @Test
  void saysWhatXmlCannotHold() {
    rename("a\u0001b");
    Workbench.display().asyncExec(() -> Workbench.page().saveEditor(editor, false));
    EditorBench.press("OK");
    assertArrayEquals(bytes, EditorBench.bytes(file));
    assertTrue(Workbench.run(editor::isDirty));
  }
}
