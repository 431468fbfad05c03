package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.model.diagram.ChainDiagram;
import dev.eventchain.model.diagram.ChainDiagram.Box;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.io.ByteArrayInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import org.eclipse.core.commands.ParameterizedCommand;
import org.eclipse.core.expressions.IEvaluationContext;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.Adapters;
import org.eclipse.core.runtime.ILogListener;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.Platform;
import org.eclipse.jface.viewers.IStructuredSelection;
import org.eclipse.jface.viewers.StructuredSelection;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Label;
import org.eclipse.swt.widgets.Listener;
import org.eclipse.ui.ISources;
import org.eclipse.ui.IViewPart;
import org.eclipse.ui.commands.ICommandService;
import org.eclipse.ui.handlers.IHandlerService;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** The diagram of a project's chain, with actions for tests. */
abstract class DiagramBench {

  private static final String ID = "dev.eventchain.eclipse.ui.diagram";

  static final Path AEB = Path.of("src/test/resources/diagram/aeb.xmi");

  private final List<IStatus> logged = new CopyOnWriteArrayList<>();

  private final ILogListener log = (status, plugin) -> logged.add(status);

  IProject project;

  IFile file;

  IViewPart view;

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

  static IViewPart showDiagram(IFile file) {
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

  ChainDiagram diagram() {
    return Adapters.adapt(view, ChainDiagram.class);
  }

  Canvas canvas() {
    return (Canvas) Adapters.adapt(view, Control.class);
  }

  int indexOf(String name) {
    List<Box> boxes = diagram().boxes();
    for (int i = 0; i < boxes.size(); i++) {
      if (boxes.get(i).name().equals(name)) {
        return i;
      }
    }
    throw new AssertionError(name + " is not among " + boxes);
  }

  static Event event(int type) {
    Event event = new Event();
    event.type = type;
    event.button = 1;
    return event;
  }

  /** Sends a mouse event over a box, at the current zoom. */
  void mouse(int type, String name) {
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

  void key(char character, int keyCode) {
    Event event = event(SWT.KeyDown);
    event.character = character;
    event.keyCode = keyCode;
    canvas().notifyListeners(SWT.KeyDown, event);
  }

  String selected() {
    var selection = (IStructuredSelection) view.getSite().getSelectionProvider().getSelection();
    return selection.getFirstElement() instanceof SoftwareNode node
        ? node.getName()
        : String.valueOf(selection.getFirstElement());
  }

  String message() {
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

  void screenshot(String name) {
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

  void write(String text) throws Exception {
    Path path = file.getLocation().toFile().toPath();
    Files.writeString(path, text);
    file.refreshLocal(IResource.DEPTH_ZERO, null);
  }

  void state(int state) {
    Workbench.run(
        () -> {
          Workbench.page().setPartState(Workbench.page().getReference(view), state);
          return view;
        });
  }
}
