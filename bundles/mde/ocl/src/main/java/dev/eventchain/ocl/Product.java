package dev.eventchain.ocl;

import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.ecore.CollectionType;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.util.OCLStandardLibraryUtil;

/**
 * What {@code product} makes: a set of tuples.
 *
 * @param type the type of the tuples
 */
record Product(EClassifier type, EStructuralFeature first, EStructuralFeature second) {

  static Product of(OperationCallExp<EClassifier, EOperation> call, OclEnvironment environment) {
    EClassifier type = ((CollectionType) call.getType()).getElementType();
    return new Product(
        type,
        environment.lookupProperty(type, OCLStandardLibraryUtil.PRODUCT_FIRST),
        environment.lookupProperty(type, OCLStandardLibraryUtil.PRODUCT_SECOND));
  }

  Collection<Object> make(
      Collection<?> left, Collection<?> right, ModelAccess environment, Evaluation run) {
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
