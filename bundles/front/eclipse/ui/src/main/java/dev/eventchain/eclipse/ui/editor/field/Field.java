package dev.eventchain.eclipse.ui.editor.field;

import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;

/** A property of the selected element, as people edit it. */
public abstract class Field {

  /** Marks the control of a field with the name of its feature. */
  public static final String FEATURE = "dev.eventchain.feature";

  private final FieldContext context;
  private final EObject element;
  private final EStructuralFeature feature;

  /** Whether the control is being filled, so that its events are not a person's. */
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

  /** Makes the control, empty. */
  public abstract Control create(Composite parent);

  /** Puts what the model says into the control, unless it is there already. */
  abstract void fill();

  /** What is wrong with what is in the control and cannot be in the model; empty for nothing. */
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

  /** Gives the property a value, null for none, unless the control is being filled. */
  final void set(Object value) {
    if (!filling) {
      context.model().set(element, feature, value);
    }
  }

  /** As {@link #set} for what is being typed. */
  final void type(Object value) {
    if (!filling) {
      context.model().stack().type(element, feature, value);
    }
  }

  final boolean isFilling() {
    return filling;
  }
}
