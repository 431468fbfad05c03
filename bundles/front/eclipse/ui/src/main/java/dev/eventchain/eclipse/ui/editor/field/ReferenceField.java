package dev.eventchain.eclipse.ui.editor.field;

import dev.eventchain.eclipse.ui.editor.model.Labels;
import java.util.Arrays;
import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.jface.layout.GridDataFactory;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Combo;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;

/** A field for a reference to another element by name; may be empty. */
public final class ReferenceField extends Field {

  private List<EObject> candidates = List.of();
  private Combo combo;
  private String problem = "";

  public ReferenceField(FieldContext context, EObject element, EReference feature) {
    super(context, element, feature);
  }

  @Override
  public Control create(Composite parent) {
    combo = new Combo(parent, SWT.DROP_DOWN);
    GridDataFactory.fillDefaults().grab(true, false).hint(100, SWT.DEFAULT).applyTo(combo);
    combo.addListener(SWT.Selection, event -> choose());
    combo.addListener(SWT.Modify, event -> read());
    Proposals.offer(context().completions(), combo, element(), feature());
    return combo;
  }

  /** Sets the element chosen from the list, which may contain several with the same name. */
  private void choose() {
    int index = combo.getSelectionIndex();
    if (index >= 0) {
      set(index == 0 ? null : candidates.get(index - 1));
    }
  }

  private void read() {
    if (isFilling()) {
      return;
    }
    String typed = combo.getText().strip();
    String before = problem;
    problem = "";
    Object now = element().eGet(feature());
    if (typed.isEmpty()) {
      set(null);
    } else if (!(now instanceof EObject target && Labels.of(target).name().equals(typed))) {
      candidates.stream()
          .filter(candidate -> Labels.of(candidate).name().equals(typed))
          .findFirst()
          .ifPresentOrElse(
              this::set, () -> problem = "Nothing in the chain is named " + typed + ".");
    }
    if (!before.equals(problem)) {
      context().checked().run();
    }
  }

  @Override
  public String problem() {
    return problem;
  }

  @Override
  void fill() {
    candidates = context().completions().candidates(element(), (EReference) feature());
    String[] items = new String[candidates.size() + 1];
    items[0] = "";
    for (int i = 1; i < items.length; i++) {
      items[i] = Labels.of(candidates.get(i - 1)).name();
    }
    String typed = combo.getText();
    if (!Arrays.equals(items, combo.getItems())) {
      combo.setItems(items);
      combo.setText(typed);
    }
    Object value = element().eGet(feature());
    String name = value == null ? "" : Labels.of(value).name();
    if (problem.isEmpty() && !combo.getText().equals(name)) {
      combo.setText(name);
    }
  }
}
