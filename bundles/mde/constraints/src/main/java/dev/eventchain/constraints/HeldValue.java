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
 * An attribute value, as the subject of constraints of its data type. Constraints of a class have
 * the objects themselves as subjects, so a list of subjects may hold both.
 *
 * @param value as the model has it
 */
record HeldValue(EObject holder, EAttribute attribute, Object value) {

  /** Returns the values of a data type that the objects store. */
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

  /** Returns the value of {@code self} for a subject. */
  static Object self(Object subject) {
    return subject instanceof HeldValue held ? held.value() : subject;
  }

  /** Returns the object that findings about a subject refer to. */
  static EObject element(Object subject) {
    return subject instanceof HeldValue held ? held.holder() : (EObject) subject;
  }

  /** Returns the label of a subject in messages. */
  static String label(Object subject) {
    return subject instanceof HeldValue held
        ? "%s %s of %s"
            .formatted(
                held.attribute().getName(), Names.ofValue(held.value()), Names.label(held.holder()))
        : Names.label((EObject) subject);
  }
}
