package dev.eventchain.constraints;

import dev.eventchain.ocl.metamodel.Names;
import dev.eventchain.ocl.metamodel.OclAnnotations;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EObject;

/**
 * A value of an attribute, which the constraints of its data type are evaluated on. Those of a
 * class are evaluated on the objects themselves, so both may be in a list of what a constraint is
 * about.
 *
 * @param value as the model has it
 */
record HeldValue(EObject holder, EAttribute attribute, Object value) {

  /** The values of a data type that objects store. */
  static List<HeldValue> of(EDataType type, Collection<? extends EObject> objects) {
    List<HeldValue> held = new ArrayList<>();
    for (EObject object : objects) {
      for (EAttribute attribute : object.eClass().getEAllAttributes()) {
        if (attribute.getEAttributeType() == type && !OclAnnotations.isComputed(attribute)) {
          add(object, attribute, held);
        }
      }
    }
    return held;
  }

  private static void add(EObject object, EAttribute attribute, List<HeldValue> held) {
    Object value = object.eGet(attribute);
    Collection<?> values = value instanceof Collection<?> several ? several : List.of();
    if (!attribute.isMany() && value != null) {
      values = List.of(value);
    }
    for (Object each : values) {
      held.add(new HeldValue(object, attribute, each));
    }
  }

  /** What {@code self} is for a subject of a constraint. */
  static Object self(Object subject) {
    return subject instanceof HeldValue held ? held.value() : subject;
  }

  /** The object that a finding about a subject is about. */
  static EObject element(Object subject) {
    return subject instanceof HeldValue held ? held.holder() : (EObject) subject;
  }

  /** What messages call a subject. */
  static String label(Object subject) {
    return subject instanceof HeldValue held
        ? "%s %s of %s"
            .formatted(
                held.attribute().getName(), Names.ofValue(held.value()), Names.label(held.holder()))
        : Names.label((EObject) subject);
  }
}
