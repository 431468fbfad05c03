package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.eclipse.diagram.ChainDiagram;
import dev.eventchain.eclipse.diagram.ChainDiagram.Box;
import dev.eventchain.eclipse.diagram.ChainDiagram.Kind;
import dev.eventchain.metamodel.XmiStore;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.SoftwareNode;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import org.eclipse.core.commands.ParameterizedCommand;
import org.eclipse.core.expressions.IEvaluationContext;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.Adapters;
import org.eclipse.core.runtime.IAdapterFactory;
import org.eclipse.core.runtime.ILogListener;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.Platform;
import org.eclipse.jface.action.ActionContributionItem;
import org.eclipse.jface.action.IContributionItem;
import org.eclipse.jface.viewers.IStructuredSelection;
import org.eclipse.jface.viewers.StructuredSelection;
import org.eclipse.swt.SWT;
import org.eclipse.swt.dnd.Clipboard;
import org.eclipse.swt.dnd.ImageTransfer;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Label;
import org.eclipse.swt.widgets.Listener;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.ISources;
import org.eclipse.ui.IViewPart;
import org.eclipse.ui.IWorkbenchPage;
import org.eclipse.ui.commands.ICommandService;
import org.eclipse.ui.handlers.IHandlerService;
import org.eclipse.ui.ide.IDE;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class DiagramViewTest {

  private static final String ID = "dev.eventchain.eclipse.ui.diagram";
  private static final Path AEB = Path.of("src/test/resources/diagram/aeb.xmi");

  private final List<IStatus> logged = new CopyOnWriteArrayList<>();
  private final ILogListener log = (status, plugin) -> logged.add(status);
  private IProject project;
  private IFile file;
  private IViewPart view;

  @BeforeEach
  void openTheViewOnAChain() throws Exception {
    Workbench.require();
    Platform.addLogListener(log);
    project = ResourcesPlugin.getWorkspace().getRoot().getProject("diagram");
    project.create(null);
    project.open(null);
    file = project.getFile("chain.xmi");
    file.create(new ByteArrayInputStream(Files.readAllBytes(AEB)), true, null);
    view = showDiagram(file);
    Workbench.waitUntil("the chain is drawn", () -> diagram().boxes().size() == 10);
  }

  @AfterEach
  void closeEverything() throws Exception {
    if (project == null) {
      return; // there is no display
    }
    Workbench.run(
        () -> {
          Workbench.page().closeAllEditors(false);
          Workbench.page().hideView(view);
          return view;
        });
    project.delete(true, true, null);
    Platform.removeLogListener(log);
    List<String> errors =
        logged.stream()
            .filter(status -> status.getSeverity() == IStatus.ERROR)
            .map(status -> status.getPlugin() + ": " + status.getMessage())
            .toList();
    assertEquals(List.of(), errors);
  }

  private static IViewPart showDiagram(IFile file) {
    return Workbench.run(
        () -> {
          var window = Workbench.page().getWorkbenchWindow();
          IHandlerService handlers = window.getService(IHandlerService.class);
          IEvaluationContext context = handlers.createContextSnapshot(false);
          context.addVariable(
              ISources.ACTIVE_CURRENT_SELECTION_NAME, new StructuredSelection(file));
          var command =
              window
                  .getService(ICommandService.class)
                  .getCommand("dev.eventchain.eclipse.ui.showDiagram");
          handlers.executeCommandInContext(new ParameterizedCommand(command, null), null, context);
          return Workbench.page().findView(ID);
        });
  }

  private ChainDiagram diagram() {
    return Adapters.adapt(view, ChainDiagram.class);
  }

  private Canvas canvas() {
    return (Canvas) Adapters.adapt(view, Control.class);
  }

  private int indexOf(String name) {
    List<Box> boxes = diagram().boxes();
    for (int i = 0; i < boxes.size(); i++) {
      if (boxes.get(i).name().equals(name)) {
        return i;
      }
    }
    throw new AssertionError(name + " is not among " + boxes);
  }

  private static Event event(int type) {
    Event event = new Event();
    event.type = type;
    event.button = 1;
    return event;
  }

  /** Sends what the mouse does over a box, at the size that it is drawn in. */
  private void mouse(int type, String name) {
    Workbench.run(
        () -> {
          key('0', 0);
          Rectangle client = canvas().getClientArea();
          var center = diagram().boxes().get(indexOf(name)).area().center();
          Event event = event(type);
          event.x = center.x() + Math.max(0, (client.width - diagram().width()) / 2);
          event.y = center.y();
          canvas().notifyListeners(type, event);
          return name;
        });
  }

  private void key(char character, int keyCode) {
    Event event = event(SWT.KeyDown);
    event.character = character;
    event.keyCode = keyCode;
    canvas().notifyListeners(SWT.KeyDown, event);
  }

  private String selected() {
    var selection = (IStructuredSelection) view.getSite().getSelectionProvider().getSelection();
    return selection.getFirstElement() instanceof SoftwareNode node
        ? node.getName()
        : String.valueOf(selection.getFirstElement());
  }

  private String message() {
    StringBuilder text = new StringBuilder();
    for (Control child : canvas().getParent().getChildren()) {
      if (child instanceof Composite bar && child.isVisible()) {
        for (Control part : bar.getChildren()) {
          text.append(part instanceof Label label ? label.getText() : "");
        }
      }
    }
    return text.toString();
  }

  private void screenshot(String name) {
    AtomicBoolean isPainted = new AtomicBoolean();
    Listener painted = event -> isPainted.set(true);
    Workbench.run(
        () -> {
          canvas().addListener(SWT.Paint, painted);
          canvas().redraw();
          return name;
        });
    Workbench.waitFor(isPainted::get, () -> "the picture is painted");
    Workbench.run(
        () -> {
          canvas().removeListener(SWT.Paint, painted);
          return name;
        });
    Workbench.screenshot(name);
  }

  private void write(String text) throws Exception {
    Path path = file.getLocation().toFile().toPath();
    Files.writeString(path, text);
    file.refreshLocal(IResource.DEPTH_ZERO, null);
  }

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
        "<?xml version=\"1.0\"?>\n<ecore:EPackage xmlns:ecore=\"http://www.eclipse.org/emf/2002/Ecore\" name=\"p\"/>\n");
    Workbench.waitUntil("no chain", () -> message().contains("holds no event chain"));
    write(text);
    Workbench.waitUntil("the picture again", () -> diagram().name().equals("AEB"));
    Workbench.waitUntil("no problem", () -> message().isEmpty());
  }

  @Test
  void survivesThatTheFileAndTheProjectGo() throws Exception {
    project.close(null);
    Workbench.waitUntil("the project is closed", () -> message().contains("not there any more"));
    mouse(SWT.MouseDown, "Braking_Decision");
    project.open(null);
    Workbench.waitUntil("the project is open", () -> message().isEmpty());
    file.move(project.getFullPath().append("moved.xmi"), true, null);
    Workbench.waitUntil(
        "the view follows", () -> view.getTitleToolTip() != null && message().isEmpty());
    project.getFile("moved.xmi").delete(true, null);
    Workbench.waitUntil("the file is gone", () -> message().contains("moved.xmi"));
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

  private void mouseMove(String name) {
    mouse(SWT.MouseMove, name);
  }

  private void state(int state) {
    Workbench.run(
        () -> {
          Workbench.page().setPartState(Workbench.page().getReference(view), state);
          return view;
        });
  }

  private void mark(String element, int severity, String message) throws Exception {
    IMarker marker = file.createMarker("dev.eventchain.eclipse.problem");
    marker.setAttribute("element", element);
    marker.setAttribute(IMarker.SEVERITY, severity);
    marker.setAttribute(IMarker.MESSAGE, message);
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
