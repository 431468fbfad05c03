package dev.eventchain.eclipse.ui.editor.field;

import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Button;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;

/** A field for a Boolean. */
public final class BooleanField extends Field {

  private Button button;

  public BooleanField(FieldContext context, EObject element, EStructuralFeature feature) {
    super(context, element, feature);
  }

  @Override
  public Control create(Composite parent) {
    button = context().toolkit().createButton(parent, "", SWT.CHECK);
    button.addListener(SWT.Selection, event -> set(button.getSelection()));
    return button;
  }

  @Override
  void fill() {
    button.setSelection((Boolean) element().eGet(feature()));
  }
}
