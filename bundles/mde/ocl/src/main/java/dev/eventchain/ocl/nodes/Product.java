package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.model.ModelAccess;
import dev.eventchain.ocl.values.InsertionOrderedSet;
import dev.eventchain.ocl.values.Limits;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * The operation {@code product}, whose result is a set of tuples.
 *
 * @param type the type of the tuples
 */
public record Product(EClassifier type, EStructuralFeature first, EStructuralFeature second) {

  Collection<Object> make(
      Collection<?> left, Collection<?> right, ModelAccess environment, Run run) {
    Limits.requireElements((long) left.size() * right.size());
    Collection<Object> result = new InsertionOrderedSet<>();
    for (Object one : left) {
      for (Object other : right) {
        run.step();
        Map<EStructuralFeature, Object> parts = new HashMap<>();
        parts.put(first, one);
        parts.put(second, other);
        result.add(environment.createTuple(type, parts));
      }
    }
    return result;
  }
}
