package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.xmi.XmiStore;
import org.eclipse.core.resources.IFile;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IWorkbenchCommandConstants;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests opening, editing, undoing and saving a chain. */
class ChainEditorTest {

  private EditorBench bench;
  private IFile file;
  private byte[] bytes;
  private IEditorPart editor;

  @BeforeEach
  void open() {
    Workbench.require();
    bench = new EditorBench("chain-editor");
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

  @Test
  void opensByContent() {
    assertEquals(EditorBench.EDITOR, Workbench.run(() -> editor.getSite().getId()));
    IFile other = bench.file("other.xmi", "<a:B xmlns:a=\"urn:a\"/>");
    IEditorPart with = EditorBench.open(other);
    assertNotEquals(EditorBench.EDITOR, Workbench.run(() -> with.getSite().getId()));
    IFile named = bench.file("named.eventchain", bytes);
    IEditorPart third = EditorBench.open(named);
    assertEquals(EditorBench.EDITOR, Workbench.run(() -> third.getSite().getId()));
  }

  @Test
  void editsAndUndoes() {
    assertFalse(Workbench.run(editor::isDirty));
    EventChain chain = EditorBench.chainOf(editor);
    EditorBench.select(editor, chain.getSoftware().get(1));
    EditorBench.type("name", "Brak");
    EditorBench.type("name", "Brakes");
    assertEquals("Brakes", chain.getSoftware().get(1).getName());
    assertTrue(Workbench.run(editor::isDirty));
    EditorBench.command(IWorkbenchCommandConstants.EDIT_UNDO);
    assertEquals("Braking_Decision", EditorBench.typed("name"));
    assertFalse(Workbench.run(editor::isDirty));
    EditorBench.command(IWorkbenchCommandConstants.EDIT_REDO);
    assertEquals("Brakes", EditorBench.typed("name"));
    assertTrue(Workbench.run(editor::isDirty));
  }

  @Test
  void savesWhatTheCommandLineWouldWrite() {
    EditorBench.select(editor, EditorBench.chainOf(editor).getSoftware().get(1));
    EditorBench.type("frequency", "25.5");
    EditorBench.save(editor);
    EventChain expected = EditorBench.chain();
    expected.getSoftware().get(1).setFrequency(25.5);
    assertArrayEquals(XmiStore.toBytes(expected), EditorBench.bytes(file));
    assertFalse(Workbench.run(editor::isDirty));
    EditorBench.type("frequency", "20");
    EditorBench.save(editor);
    assertArrayEquals(bytes, EditorBench.bytes(file));
  }

  @Test
  void unsetsANumberAndRefusesWhatIsNone() {
    SoftwareNode node = EditorBench.chainOf(editor).getSoftware().get(1);
    EditorBench.select(editor, node);
    EditorBench.type("frequency", "12 Hz");
    assertEquals(20.0, node.getFrequency());
    EditorBench.type("frequency", "");
    assertFalse(node.isSetFrequency());
    EditorBench.command(IWorkbenchCommandConstants.EDIT_UNDO);
    assertEquals("20", EditorBench.typed("frequency"));
  }
}
