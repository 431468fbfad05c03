package dev.eventchain.eclipse.ui.editor.field;

import dev.eventchain.eclipse.ui.editor.model.Icon;
import dev.eventchain.eclipse.ui.editor.model.Labels;
import dev.eventchain.eclipse.ui.editor.model.Structure;
import dev.eventchain.eclipse.ui.editor.model.Words;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.eclipse.emf.common.util.EList;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.jface.layout.GridDataFactory;
import org.eclipse.jface.layout.GridLayoutFactory;
import org.eclipse.jface.resource.JFaceResources;
import org.eclipse.jface.resource.LocalResourceManager;
import org.eclipse.jface.resource.ResourceManager;
import org.eclipse.jface.viewers.ArrayContentProvider;
import org.eclipse.jface.viewers.LabelProvider;
import org.eclipse.jface.viewers.TableViewer;
import org.eclipse.jface.window.Window;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.widgets.Button;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.ui.dialogs.ElementListSelectionDialog;

/** A field for an ordered list of references. */
public final class ReferencesField extends Field {

  private static final int LINES = 5;

  private TableViewer viewer;
  private Button add;
  private Button remove;
  private Button up;
  private Button down;
  private List<Object> shown = List.of();

  public ReferencesField(FieldContext context, EObject element, EReference feature) {
    super(context, element, feature);
  }

  @Override
  public Control create(Composite parent) {
    Composite area = context().toolkit().createComposite(parent);
    GridLayoutFactory.fillDefaults().numColumns(2).applyTo(area);
    GridDataFactory.fillDefaults().grab(true, false).applyTo(area);
    viewer = new TableViewer(area, SWT.MULTI | SWT.BORDER | SWT.V_SCROLL);
    int height = LINES * viewer.getTable().getItemHeight();
    GridDataFactory.fillDefaults().grab(true, true).hint(100, height).applyTo(viewer.getTable());
    viewer.setContentProvider(ArrayContentProvider.getInstance());
    viewer.setLabelProvider(new Names());
    viewer.addSelectionChangedListener(event -> enable());
    viewer.addDoubleClickListener(
        event ->
            context().reveal().accept((EObject) viewer.getStructuredSelection().getFirstElement()));
    Composite buttons = context().toolkit().createComposite(area);
    GridLayoutFactory.fillDefaults().applyTo(buttons);
    add = button(buttons, "Add\u2026", this::add);
    remove = button(buttons, "Remove", this::remove);
    up = button(buttons, "Up", () -> move(-1));
    down = button(buttons, "Down", () -> move(1));
    return area;
  }

  private Button button(Composite parent, String text, Runnable action) {
    Button button = context().toolkit().createButton(parent, text, SWT.PUSH);
    GridDataFactory.fillDefaults().grab(true, false).applyTo(button);
    button.addListener(SWT.Selection, event -> action.run());
    return button;
  }

  private EList<Object> values() {
    return Structure.list(element(), (EReference) feature());
  }

  private List<EObject> addable() {
    return context().completions().candidates(element(), (EReference) feature()).stream()
        .filter(candidate -> !values().contains(candidate))
        .toList();
  }

  private void add() {
    ElementListSelectionDialog dialog =
        new ElementListSelectionDialog(viewer.getControl().getShell(), new Names());
    dialog.setTitle("Add to " + Words.of(feature()).toLowerCase(Locale.ROOT));
    dialog.setMessage(Words.documentation(feature()));
    dialog.setMultipleSelection(true);
    dialog.setElements(addable().toArray());
    if (dialog.open() == Window.OK) {
      List<EObject> chosen = Arrays.stream(dialog.getResult()).map(EObject.class::cast).toList();
      context().model().change("add", () -> values().addAll(chosen));
    }
  }

  private List<EObject> selected() {
    return Arrays.stream(viewer.getStructuredSelection().toArray())
        .map(EObject.class::cast)
        .toList();
  }

  private void remove() {
    List<EObject> selected = selected();
    context().model().change("remove", () -> values().removeAll(selected));
  }

  private void move(int by) {
    EObject one = selected().get(0);
    context()
        .model()
        .change(
            by < 0 ? "move up" : "move down", () -> values().move(values().indexOf(one) + by, one));
  }

  private void enable() {
    List<EObject> selected = selected();
    int index = selected.size() == 1 ? values().indexOf(selected.get(0)) : -1;
    add.setEnabled(!addable().isEmpty());
    remove.setEnabled(!selected.isEmpty());
    up.setEnabled(index > 0);
    down.setEnabled(index >= 0 && index < values().size() - 1);
  }

  @Override
  void fill() {
    List<Object> values = List.copyOf(values());
    if (!values.equals(shown) || viewer.getInput() == null) {
      shown = values;
      viewer.setInput(values);
    } else {
      viewer.refresh(true);
    }
    enable();
  }

  /** Labels of elements in lists. */
  private static final class Names extends LabelProvider {

    private final ResourceManager images = new LocalResourceManager(JFaceResources.getResources());

    @Override
    public String getText(Object element) {
      return Labels.of(element).text();
    }

    @Override
    public Image getImage(Object element) {
      return images.create(Icon.of(element).descriptor());
    }

    @Override
    public void dispose() {
      images.dispose();
      super.dispose();
    }
  }
}
