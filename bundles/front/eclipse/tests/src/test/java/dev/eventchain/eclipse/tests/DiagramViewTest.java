package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.diagram.ChainDiagram.Kind;
import dev.eventchain.xmi.XmiStore;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.List;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.jface.action.ActionContributionItem;
import org.eclipse.jface.action.IContributionItem;
import org.eclipse.swt.SWT;
import org.eclipse.swt.dnd.Clipboard;
import org.eclipse.swt.dnd.ImageTransfer;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IWorkbenchPage;
import org.junit.jupiter.api.Test;

/** Tests the contents of the diagram and its response to mouse and keyboard. */
class DiagramViewTest extends DiagramBench {

  @Test
  void drawsAChainAndShowsWhatIsClicked() {
    screenshot("diagram-small");
    assertEquals(Kind.SIGNAL_IN, diagram().boxes().get(indexOf("/carla/ego_vehicle/lidar")).kind());
    mouse(SWT.MouseDown, "Braking_Decision");
    assertEquals("Braking_Decision", Workbench.run(this::selected));
    IEditorPart editor = Workbench.run(() -> Workbench.page().getActiveEditor());
    assertEquals(file, editor.getEditorInput().getAdapter(IFile.class));
    assertEquals(view, Workbench.run(() -> Workbench.page().getActivePart()));
    mouse(SWT.MouseDoubleClick, "Braking_Decision");
    assertEquals(editor, Workbench.run(() -> Workbench.page().getActivePart()));
  }

  @Test
  void movesWithTheKeyboard() {
    mouse(SWT.MouseDown, "ObjectDetection");
    for (String next : List.of("Data", "TTC_Calculation", "Data", "Braking_Decision")) {
      Workbench.run(
          () -> {
            key('\0', SWT.ARROW_DOWN);
            return next;
          });
      assertTrue(Workbench.run(this::selected).contains(next), Workbench.run(this::selected));
    }
    Workbench.run(
        () -> {
          key('\0', SWT.HOME);
          key('\r', SWT.CR);
          return view;
        });
    assertTrue(Workbench.run(() -> Workbench.page().getActivePart()) instanceof IEditorPart);
  }

  @Test
  void marksWhatHasProblems() throws Exception {
    mark("EventChain[AEB]/software[Braking_Decision]", IMarker.SEVERITY_ERROR, "too slow & late");
    mark("EventChain[AEB]/software[TTC_Calculation]/x", IMarker.SEVERITY_WARNING, "doubtful");
    mark("EventChain[AEB]/data[velocity]", IMarker.SEVERITY_WARNING, "no unit");
    Workbench.waitUntil(
        "the marker is seen",
        () -> {
          mouseMove("/carla/ego_vehicle/vehicle_status");
          mouseMove("Braking_Decision");
          return canvas().getToolTipText().contains("too slow && late");
        });
    Workbench.run(
        () -> {
          mouseMove("ObjectDetection");
          return view;
        });
    assertTrue(Workbench.run(() -> canvas().getToolTipText()).contains("20 Hz"));
    mouse(SWT.MouseDown, "TTC_Calculation");
    state(IWorkbenchPage.STATE_MAXIMIZED);
    screenshot("diagram");
    state(IWorkbenchPage.STATE_RESTORED);
  }

  @Test
  void topicsSayTheUnitsOfMessagesAndOfComponents() throws Exception {
    String plain = "<data name=\"velocity\"";
    String units = plain + " unit=\"km/h\" componentUnit=\"m/s\"";
    write(Files.readString(AEB).replace(plain, units));
    Workbench.waitUntil(
        "the units",
        () -> {
          mouseMove("Braking_Decision");
          mouseMove("/carla/ego_vehicle/vehicle_status");
          String text = String.valueOf(canvas().getToolTipText());
          return text.contains("velocity [km/h, m/s in the component]");
        });
  }

  private void mouseMove(String name) {
    mouse(SWT.MouseMove, name);
  }

  private void mark(String element, int severity, String message) throws Exception {
    IMarker marker = file.createMarker("dev.eventchain.eclipse.problem");
    marker.setAttribute("element", element);
    marker.setAttribute(IMarker.SEVERITY, severity);
    marker.setAttribute(IMarker.MESSAGE, message);
  }

  @Test
  void drawsLargeChainsAndCycles() throws Exception {
    String[] components = new String[500];
    for (int i = 0; i < components.length; i++) {
      components[i] =
          "t" + i + " t" + (i * 7 % 500) + " > t" + (i + 1) + (i % 9 == 8 ? " t" + (i - 5) : "");
    }
    write(new String(XmiStore.toBytes(Chains.of(components)), StandardCharsets.UTF_8));
    Workbench.waitUntil("the large chain", () -> diagram().boxes().size() == 1001);
    state(IWorkbenchPage.STATE_MAXIMIZED);
    Workbench.run(
        () ->
            run(view.getViewSite().getActionBars().getToolBarManager().getItems(), "Zoom to &Fit"));
    screenshot("diagram-large");
    String[] cycle = {"in back > a b", "a > c", "b > d", "c d loop > out back loop"};
    write(new String(XmiStore.toBytes(Chains.of(cycle)), StandardCharsets.UTF_8));
    Workbench.waitUntil("the cycle", () -> diagram().boxes().size() == 12);
    mouse(SWT.MouseDown, "N0");
    state(IWorkbenchPage.STATE_MAXIMIZED);
    screenshot("diagram-cycle");
    state(IWorkbenchPage.STATE_RESTORED);
  }

  @Test
  void zoomsAndCopiesThePicture() throws Exception {
    for (String action : List.of("Zoom &In", "Zoom &Out", "Zoom to &Fit")) {
      Workbench.run(
          () -> run(view.getViewSite().getActionBars().getToolBarManager().getItems(), action));
    }
    screenshot("diagram-fit");
    Workbench.run(
        () -> run(view.getViewSite().getActionBars().getMenuManager().getItems(), "&Copy Picture"));
    ImageData image =
        Workbench.run(
            () -> {
              Clipboard clipboard = new Clipboard(Workbench.display());
              Object contents = clipboard.getContents(ImageTransfer.getInstance());
              clipboard.dispose();
              return (ImageData) contents;
            });
    assertEquals(2 * Workbench.run(this::diagram).width(), image.width);
  }

  private static String run(IContributionItem[] items, String text) {
    for (IContributionItem item : items) {
      if (item instanceof ActionContributionItem action
          && text.equals(action.getAction().getText())) {
        action.getAction().run();
        return text;
      }
    }
    throw new AssertionError("there is no " + text);
  }
}
