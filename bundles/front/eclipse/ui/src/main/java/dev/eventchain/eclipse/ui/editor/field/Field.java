package dev.eventchain.eclipse.ui.editor.field;

import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;

/** A field for a property of the selected element. */
public abstract class Field {

  /** Key for the feature's name in the control of a field. */
  public static final String FEATURE = "dev.eventchain.feature";

  private final FieldContext context;
  private final EObject element;
  private final EStructuralFeature feature;

  /** True while the control is being filled, so that its events are not a person's. */
  private boolean filling;

  Field(FieldContext context, EObject element, EStructuralFeature feature) {
    this.context = context;
    this.element = element;
    this.feature = feature;
  }

  final FieldContext context() {
    return context;
  }

  public final EObject element() {
    return element;
  }

  public final EStructuralFeature feature() {
    return feature;
  }

  /** Creates the control, empty. */
  public abstract Control create(Composite parent);

  /** Updates the control to the model's value, unless it already has it. */
  abstract void fill();

  /** Returns the problem of an input that the model cannot hold; empty if there is none. */
  public String problem() {
    return "";
  }

  public final void refresh() {
    filling = true;
    try {
      fill();
    } finally {
      filling = false;
    }
  }

  /** Sets the property, null for none, unless the control is being filled. */
  final void set(Object value) {
    if (!filling) {
      context.model().set(element, feature, value);
    }
  }

  /** As {@link #set}, for a value being typed. */
  final void type(Object value) {
    if (!filling) {
      context.model().stack().type(element, feature, value);
    }
  }

  final boolean isFilling() {
    return filling;
  }
}
