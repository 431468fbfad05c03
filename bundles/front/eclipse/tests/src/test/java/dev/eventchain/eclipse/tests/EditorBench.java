package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.QosProfile;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.xmi.XmiStore;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Predicate;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.ILogListener;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.Platform;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.jface.viewers.StructuredSelection;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Button;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Menu;
import org.eclipse.swt.widgets.MenuItem;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.eclipse.swt.widgets.Tree;
import org.eclipse.swt.widgets.Widget;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.handlers.IHandlerService;
import org.eclipse.ui.ide.IDE;

/** A project with a chain in the workspace, and an editor on it. */
final class EditorBench implements AutoCloseable {

  static final String EDITOR = "dev.eventchain.eclipse.ui.editor";

  private final IProject project;

  /** Entries of the error log; there must be none. */
  private final List<String> logged = new CopyOnWriteArrayList<>();

  private final ILogListener listener = (status, plugin) -> log(status);

  EditorBench(String name) {
    Platform.addLogListener(listener);
    project = ResourcesPlugin.getWorkspace().getRoot().getProject(name);
    work(
        () -> {
          if (project.exists()) {
            project.delete(true, true, null);
          }
          project.create(null);
          project.open(null);
        });
  }

  private void log(IStatus status) {
    String trace =
        status.getException() == null ? "" : Arrays.toString(status.getException().getStackTrace());
    if (status.getSeverity() == IStatus.ERROR && (status + trace).contains("dev.eventchain")) {
      logged.add(status + " " + trace);
    }
  }

  interface Work {
    void run() throws CoreException;
  }

  static void work(Work work) {
    try {
      work.run();
    } catch (CoreException e) {
      throw new AssertionError(e);
    }
  }

  IProject project() {
    return project;
  }

  IFile file(String name, byte[] bytes) {
    IFile file = project.getFile(name);
    work(
        () -> {
          if (file.exists()) {
            file.setContents(new ByteArrayInputStream(bytes), IResource.FORCE, null);
          } else {
            file.create(new ByteArrayInputStream(bytes), IResource.FORCE, null);
          }
        });
    return file;
  }

  IFile file(String name, String text) {
    return file(name, text.getBytes(StandardCharsets.UTF_8));
  }

  static byte[] bytes(IFile file) {
    try (java.io.InputStream stream = file.getContents(true)) {
      return stream.readAllBytes();
    } catch (CoreException | java.io.IOException e) {
      throw new AssertionError(e);
    }
  }

  /** Returns a valid chain in which one component reads the data that the other one writes. */
  static EventChain chain() {
    EventchainFactory factory = EventchainFactory.eINSTANCE;
    EventChain chain = factory.createEventChain();
    chain.setName("aeb");
    SoftwareNode first = node(chain, "TTC_Calculation");
    SoftwareNode second = node(chain, "Braking_Decision");
    first.setNextstep(second);
    data(chain, first.getInput(), "distance", "/scan", "sensor_msgs/msg/LaserScan", "range_min");
    Data ttc = data(chain, first.getOutput(), "ttc", "/ttc", "std_msgs/msg/Float32", "data");
    QosProfile qos = factory.createQosProfile();
    qos.setName("default");
    ttc.setQos(qos);
    data(chain, second.getInput(), "ttc", "/ttc", "std_msgs/msg/Float32", "data");
    data(chain, second.getOutput(), "brake", "/brake", "std_msgs/msg/Float32", "data");
    Requirement requirement = factory.createRequirement();
    requirement.setId("AEB-1");
    requirement.setText("The system shall brake before it is too late.");
    chain.getRequirements().add(requirement);
    second.getSatisfies().add(requirement);
    LatencyConstraint latency = factory.createLatencyConstraint();
    latency.setName("DR-3");
    latency.setFirst(first);
    latency.setLast(second);
    latency.setMaximum(250);
    chain.getLatencyConstraints().add(latency);
    return chain;
  }

  private static SoftwareNode node(EventChain chain, String name) {
    SoftwareNode node = EventchainFactory.eINSTANCE.createSoftwareNode();
    node.setName(name);
    node.setFrequency(20);
    chain.getSoftware().add(node);
    return node;
  }

  private static Data data(
      EventChain chain, List<Data> of, String name, String topic, String type, String field) {
    Data data = EventchainFactory.eINSTANCE.createData();
    data.setName(name);
    data.setTopicName(topic);
    data.setMessageType(type);
    data.setFieldName(field);
    data.setType("float32");
    chain.getData().add(data);
    of.add(data);
    return data;
  }

  static IEditorPart open(IFile file) {
    return Workbench.run(
        () -> {
          Workbench.page().getWorkbenchWindow().getShell().forceActive();
          return IDE.openEditor(Workbench.page(), file);
        });
  }

  static EventChain chainOf(IEditorPart editor) {
    return Workbench.run(() -> editor.getAdapter(EventChain.class));
  }

  static byte[] bytesOf(IEditorPart editor) {
    return Workbench.run(() -> XmiStore.toBytes(editor.getAdapter(EventChain.class)));
  }

  static void select(IEditorPart editor, EObject element) {
    Workbench.run(
        () -> {
          editor.getSite().getSelectionProvider().setSelection(new StructuredSelection(element));
          return element;
        });
  }

  /** Runs a command of the workbench, as from its menu. */
  static void command(String id) {
    Workbench.run(
        () ->
            Workbench.page()
                .getWorkbenchWindow()
                .getService(IHandlerService.class)
                .executeCommand(id, null));
  }

  static void save(IEditorPart editor) {
    Workbench.run(() -> Workbench.page().saveEditor(editor, false));
  }

  static void type(String feature, String text) {
    Workbench.run(
        () -> {
          field(Text.class, feature).setText(text);
          return feature;
        });
  }

  static String typed(String feature) {
    return Workbench.run(() -> field(Text.class, feature).getText());
  }

  /** Returns the control of a feature of the selection; in the user interface's thread only. */
  static <T extends Control> T field(Class<T> type, String feature) {
    return find(type, control -> feature.equals(control.getData("dev.eventchain.feature")));
  }

  /** Returns a control in any window; in the user interface's thread only. */
  static <T extends Control> T find(Class<T> type, Predicate<T> wanted) {
    for (Shell shell : Workbench.display().getShells()) {
      List<Control> all = new ArrayList<>(List.of(shell));
      for (int i = 0; i < all.size(); i++) {
        if (all.get(i) instanceof Composite composite) {
          all.addAll(List.of(composite.getChildren()));
        }
        if (type.isInstance(all.get(i)) && wanted.test(type.cast(all.get(i)))) {
          return type.cast(all.get(i));
        }
      }
    }
    return null;
  }

  /** Waits for a dialog and presses one of its buttons. */
  static void press(String text) {
    Workbench.waitUntil("a button " + text, () -> button(text) != null);
    Workbench.display().asyncExec(() -> click(button(text)));
    Workbench.waitUntil("the button " + text + " is gone", () -> button(text) == null);
  }

  /** Chooses an item from the menu of a tree, by the texts of menu and submenus. */
  static void choose(Tree tree, String... texts) {
    Menu menu = tree.getMenu();
    List<Menu> shown = new ArrayList<>();
    for (String text : texts) {
      menu.notifyListeners(SWT.Show, new Event());
      shown.add(menu);
      MenuItem item =
          Arrays.stream(menu.getItems())
              .filter(each -> each.getText().replace("&", "").split("\t")[0].equals(text))
              .findFirst()
              .orElseThrow();
      menu = item.getMenu();
      if (menu == null) {
        click(item);
      }
    }
    shown.forEach(each -> each.notifyListeners(SWT.Hide, new Event()));
  }

  static Button button(String text) {
    return find(
        Button.class,
        button -> button.getText().replace("&", "").equals(text) && button.isVisible());
  }

  static void click(Widget widget) {
    widget.notifyListeners(SWT.Selection, new Event());
  }

  @Override
  public void close() {
    Workbench.run(() -> Workbench.page().closeAllEditors(false));
    work(() -> project.delete(true, true, null));
    Platform.removeLogListener(listener);
    assertEquals(List.of(), logged);
  }
}
