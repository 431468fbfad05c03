package dev.eventchain.eclipse.ui.editor.field;

import java.util.List;
import java.util.Locale;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.jface.layout.GridDataFactory;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Combo;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;

/** A field for an enumeration; may be empty if the metamodel allows it. */
public final class EnumField extends Field {

  private final List<EEnumLiteral> literals;
  private final int first;
  private Combo combo;

  public EnumField(FieldContext context, EObject element, EStructuralFeature feature) {
    super(context, element, feature);
    literals = ((EEnum) feature.getEType()).getELiterals();
    first = feature.isUnsettable() ? 1 : 0;
  }

  @Override
  public Control create(Composite parent) {
    combo = new Combo(parent, SWT.READ_ONLY);
    GridDataFactory.swtDefaults().hint(180, SWT.DEFAULT).applyTo(combo);
    if (first == 1) {
      combo.add("(not set)");
    }
    literals.forEach(literal -> combo.add(words(literal)));
    combo.addListener(SWT.Selection, event -> set(chosen()));
    return combo;
  }

  private static String words(EEnumLiteral literal) {
    return literal.getName().toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  private Object chosen() {
    int index = combo.getSelectionIndex() - first;
    return index < 0 ? null : literals.get(index).getInstance();
  }

  @Override
  void fill() {
    int index = 0;
    if (first == 0 || element().eIsSet(feature())) {
      Object value = element().eGet(feature());
      index = first;
      while (literals.get(index - first).getInstance() != value) {
        index++;
      }
    }
    if (combo.getSelectionIndex() != index) {
      combo.select(index);
    }
  }
}
