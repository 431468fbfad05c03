package dev.eventchain.eclipse.ui.editor.field;

import dev.eventchain.eclipse.ui.editor.model.Labels;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.jface.layout.GridDataFactory;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Text;

/** A measured value of a run, which people do not edit. */
public final class ReadOnlyField extends Field {

  private Text text;

  public ReadOnlyField(FieldContext context, EObject element, EStructuralFeature feature) {
    super(context, element, feature);
  }

  @Override
  public Control create(Composite parent) {
    text = new Text(parent, SWT.READ_ONLY | SWT.SINGLE);
    GridDataFactory.fillDefaults().grab(true, false).hint(100, SWT.DEFAULT).applyTo(text);
    return text;
  }

  @Override
  void fill() {
    Object value = element().eGet(feature());
    String words = value == null ? "" : value.toString();
    if (feature().isUnsettable() && !element().eIsSet(feature())) {
      words = "";
    } else if (value instanceof EObject target) {
      words = Labels.of(target).name();
    } else if (value instanceof Double number) {
      words = Labels.number(number);
    }
    if (!text.getText().equals(words)) {
      text.setText(words);
    }
  }
}
