package dev.eventchain.eclipse.ui.editor.field;

import java.util.Objects;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.jface.layout.GridDataFactory;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Text;

/** A field for a text; an empty one is unset. */
public final class TextField extends Field {

  private static final int LINES = 4;

  private final boolean isLong;
  private Text text;

  /** * @param isLong true for several lines */
  public TextField(
      FieldContext context, EObject element, EStructuralFeature feature, boolean isLong) {
    super(context, element, feature);
    this.isLong = isLong;
  }

  @Override
  public Control create(Composite parent) {
    int style = isLong ? SWT.MULTI | SWT.WRAP | SWT.V_SCROLL : SWT.SINGLE;
    text = context().toolkit().createText(parent, "", style | SWT.BORDER);
    int height = isLong ? LINES * text.getLineHeight() : SWT.DEFAULT;
    GridDataFactory.fillDefaults().grab(true, false).hint(100, height).applyTo(text);
    text.addModifyListener(event -> type(text.getText().isEmpty() ? null : text.getText()));
    text.addListener(SWT.FocusOut, event -> context().model().stack().endTyping());
    Proposals.offer(context().completions(), text, element(), feature());
    return text;
  }

  @Override
  void fill() {
    String value = Objects.toString(element().eGet(feature()), "");
    if (!text.getText().equals(value)) {
      text.setText(value);
    }
  }
}
