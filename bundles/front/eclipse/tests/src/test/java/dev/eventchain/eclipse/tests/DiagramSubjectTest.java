package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.IAdapterFactory;
import org.eclipse.core.runtime.Platform;
import org.eclipse.jface.viewers.IStructuredSelection;
import org.eclipse.jface.viewers.StructuredSelection;
import org.eclipse.swt.SWT;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IWorkbenchPart2;
import org.eclipse.ui.ide.IDE;
import org.junit.jupiter.api.Test;

/** Tests which chain the diagram shows as files, editors and projects change. */
class DiagramSubjectTest extends DiagramBench {

  @Test
  void followsTheFile() throws Exception {
    String text = Files.readString(AEB);
    write(
        text.replace("  <data", "  <software name=\"Extra\"/>\n  <data")
            .replaceFirst("name=\"AEB\"", "name=\"Other\""));
    Workbench.waitUntil("the new picture", () -> diagram().name().equals("Other"));
    assertTrue(Workbench.run(() -> indexOf("Extra")) > 0);
    write(text.replace("</eventchain:EventChain>", ""));
    Workbench.waitUntil("the problem", () -> message().startsWith("chain.xmi:"));
    assertEquals("Other", Workbench.run(() -> diagram().name()));
    screenshot("diagram-broken");
    write(
        "<?xml version=\"1.0\"?>\n"
            + "<ecore:EPackage xmlns:ecore=\"http://www.eclipse.org/emf/2002/Ecore\""
            + " name=\"p\"/>\n");
    Workbench.waitUntil("no chain", () -> message().contains("contains no event chain"));
    write(text);
    Workbench.waitUntil("the picture again", () -> diagram().name().equals("AEB"));
    Workbench.waitUntil("no problem", () -> message().isEmpty());
  }

  @Test
  void survivesThatTheFileAndTheProjectGo() throws Exception {
    project.close(null);
    Workbench.waitUntil("the project is closed", () -> message().contains("no longer exists"));
    mouse(SWT.MouseDown, "Braking_Decision");
    project.open(null);
    Workbench.waitUntil("the project is open", () -> message().isEmpty());
    file.move(project.getFullPath().append("moved.xmi"), true, null);
    Workbench.waitUntil(
        "the view follows",
        () -> ((IWorkbenchPart2) view).getContentDescription().contains("moved.xmi"));
    assertEquals("", Workbench.run(this::message));
    project.getFile("moved.xmi").delete(true, null);
    Workbench.waitUntil("the file is gone", () -> message().contains("moved.xmi"));
  }

  @Test
  void followsTheObjectOfAnEditor() throws Exception {
    EventChain chain = Chains.of("in > a", "a > out");
    IEditorPart editor =
        Workbench.run(
            () -> IDE.openEditor(Workbench.page(), file, "org.eclipse.ui.DefaultTextEditor"));
    IAdapterFactory adapters =
        new IAdapterFactory() {
          @Override
          public <T> T getAdapter(Object object, Class<T> type) {
            return type.cast(chain);
          }

          @Override
          public Class<?>[] getAdapterList() {
            return new Class<?>[] {EventChain.class};
          }
        };
    Platform.getAdapterManager().registerAdapters(adapters, editor.getClass());
    try {
      showDiagram(file);
      Workbench.waitUntil("the editor's chain", () -> diagram().name().equals("test"));
      Workbench.run(() -> Chains.add(chain, "Added"));
      Workbench.waitUntil("the change", () -> diagram().boxes().size() == 6);
      Workbench.run(() -> Workbench.page().closeEditor(editor, false));
      Workbench.waitUntil("the file again", () -> diagram().name().equals("AEB"));
      assertTrue(chain.eAdapters().isEmpty());
    } finally {
      Platform.getAdapterManager().unregisterAdapters(adapters);
    }
  }

  @Test
  void goesWithTheEditorOfChains() throws Exception {
    IFile edited = project.getFile("edited.eventchain");
    edited.create(new ByteArrayInputStream("<broken".getBytes(StandardCharsets.UTF_8)), true, null);
    IEditorPart editor = EditorBench.open(edited);
    Workbench.waitUntil("the problem", () -> message().startsWith("edited.eventchain:"));
    file = edited;
    write(Files.readString(AEB));
    Workbench.waitUntil(
        "the editor's chain is drawn",
        () -> {
          EventChain chain = editor.getAdapter(EventChain.class);
          return chain != null
              && !diagram().boxes().isEmpty()
              && diagram().boxes().get(0).element() == chain.getSoftware().get(0);
        });
    SoftwareNode node = EditorBench.chainOf(editor).getSoftware().get(2);
    mouse(SWT.MouseDown, "Braking_Decision");
    assertEquals(node, Workbench.run(() -> selectedIn(editor)));
    SoftwareNode last = EditorBench.chainOf(editor).getSoftware().get(3);
    Workbench.run(
        () -> {
          Workbench.page().activate(editor);
          editor.getSite().getSelectionProvider().setSelection(new StructuredSelection(last));
          last.setName("Renamed");
          return last;
        });
    Workbench.waitUntil("the change", () -> diagram().boxes().get(3).name().equals("Renamed"));
    assertEquals("Renamed", Workbench.run(this::selected));
    screenshot("diagram-editor");
    Workbench.run(() -> Workbench.page().closeEditor(editor, false));
    Workbench.waitUntil(
        "what is saved", () -> diagram().boxes().get(3).name().equals("Carla_Vehicle_Control"));
  }

  private static Object selectedIn(IEditorPart editor) {
    var provider = editor.getSite().getSelectionProvider();
    return ((IStructuredSelection) provider.getSelection()).getFirstElement();
  }
}
