package dev.eventchain.eclipse.ui.editor.field;

import dev.eventchain.eclipse.ui.editor.model.Labels;
import java.util.Optional;
import java.util.regex.Pattern;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.jface.layout.GridDataFactory;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Text;

/**
 * A field for a number; may be empty if the metamodel allows it. Invalid input is reported, and the
 * model keeps its value.
 */
public final class NumberField extends Field {

  private static final Pattern DECIMAL =
      Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

  private Text text;
  private String problem = "";

  public NumberField(FieldContext context, EObject element, EStructuralFeature feature) {
    super(context, element, feature);
  }

  @Override
  public Control create(Composite parent) {
    text = context().toolkit().createText(parent, "", SWT.SINGLE | SWT.BORDER);
    GridDataFactory.swtDefaults().hint(120, SWT.DEFAULT).applyTo(text);
    text.addModifyListener(event -> read());
    text.addListener(SWT.FocusOut, event -> context().model().stack().endTyping());
    return text;
  }

  private void read() {
    if (isFilling()) {
      return;
    }
    String before = problem;
    String typed = text.getText().strip();
    Optional<Number> number = parse(typed);
    if (typed.isEmpty() && feature().isUnsettable()) {
      problem = "";
      type(null);
    } else if (number.isPresent()) {
      problem = "";
      type(number.get());
    } else {
      problem =
          isWhole() ? "This is not a whole number." : "This is not a number, such as 20 or 0.5.";
    }
    if (!before.equals(problem)) {
      context().checked().run();
    }
  }

  private boolean isWhole() {
    return feature().getEType() == EcorePackage.Literals.EINT;
  }

  private Optional<Number> parse(String typed) {
    try {
      if (isWhole()) {
        return Optional.of(Integer.valueOf(typed));
      }
      double value = DECIMAL.matcher(typed).matches() ? Double.parseDouble(typed) : Double.NaN;
      return Double.isFinite(value) ? Optional.of(value) : Optional.empty();
    } catch (NumberFormatException e) { // the field reports it
      return Optional.empty();
    }
  }

  @Override
  public String problem() {
    return problem;
  }

  @Override
  void fill() {
    boolean isSet = !feature().isUnsettable() || element().eIsSet(feature());
    Object value = element().eGet(feature());
    String typed = text.getText().strip();
    boolean stands = isSet ? parse(typed).filter(value::equals).isPresent() : typed.isEmpty();
    if (!stands && problem.isEmpty()) {
      text.setText(!isSet ? "" : isWhole() ? value.toString() : Labels.number((Double) value));
    }
  }
}
