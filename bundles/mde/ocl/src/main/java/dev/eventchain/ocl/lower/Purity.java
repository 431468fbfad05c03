package dev.eventchain.ocl.lower;

import dev.eventchain.ocl.parse.Libraries;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.ocl.expressions.CallExp;
import org.eclipse.ocl.expressions.LoopExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.PropertyCallExp;
import org.eclipse.ocl.expressions.Variable;
import org.eclipse.ocl.expressions.VariableExp;
import org.eclipse.ocl.utilities.PredefinedType;

/** Dependencies of the values of expressions. */
final class Purity {

  private final Lowering lowering;

  /** The purity of expressions; false while it is being determined. */
  private final Map<OCLExpression<EClassifier>, Boolean> functions = new HashMap<>();

  Purity(Lowering lowering) {
    this.lowering = lowering;
  }

  /** Returns whether an expression reads a variable. */
  static boolean reads(OCLExpression<EClassifier> expression, Variable<?, ?> variable) {
    return parts(expression)
        .anyMatch(
            part -> part instanceof VariableExp<?, ?> use && use.getReferredVariable() == variable);
  }

  /** Returns whether an expression reads no variables but its own and perhaps a given one. */
  static boolean readsOnly(OCLExpression<EClassifier> expression, Variable<?, ?> variable) {
    return parts(expression)
        .allMatch(
            part ->
                !(part instanceof VariableExp<?, ?> use)
                    || (variable != null && use.getReferredVariable() == variable)
                    || isWithin(use.getReferredVariable(), expression));
  }

  private static boolean isWithin(Object variable, OCLExpression<EClassifier> expression) {
    return variable instanceof EObject object && EcoreUtil.isAncestor((EObject) expression, object);
  }

  /**
   * Returns whether a loop or an operation of OCL has the same value for all elements, which it
   * finds from the instances of a class: as in {@code X.allInstances()->isUnique(name)}.
   */
  boolean isOfModel(OCLExpression<EClassifier> expression) {
    boolean computes =
        expression instanceof LoopExp<?, ?>
            || (expression instanceof OperationCallExp<?, ?> call && isStandard(call));
    return computes
        && parts(expression).anyMatch(Purity::isExtent)
        && readsOnly(expression, null)
        && isFunction(expression);
  }

  private static boolean isStandard(OperationCallExp<?, ?> call) {
    return call.getOperationCode() > 0
        && !isExtent((EObject) call)
        && !(call.getReferredOperation() instanceof Libraries.LibraryOperation);
  }

  private static boolean isExtent(EObject part) {
    return part instanceof OperationCallExp<?, ?> call
        && call.getOperationCode() == PredefinedType.ALL_INSTANCES;
  }

  /**
   * Returns whether an expression is pure, including its calls. Recursive ones do not count: they
   * may not terminate for some elements.
   */
  boolean isFunction(OCLExpression<EClassifier> expression) {
    Boolean known = functions.get(expression);
    if (known == null) {
      functions.put(expression, false);
      known = parts(expression).allMatch(this::isFunctionItself);
      functions.put(expression, known);
    }
    return known;
  }

  private boolean isFunctionItself(EObject part) {
    if (part instanceof OperationCallExp<?, ?> call) {
      EOperation operation = (EOperation) call.getReferredOperation();
      if (operation instanceof Libraries.LibraryOperation library) {
        return library.implementation().isRepeatable();
      }
      return isFunction(call, operation).orElse(call.getOperationCode() > 0);
    } else if (part instanceof PropertyCallExp<?, ?> call) {
      return isFunction(call, (EStructuralFeature) call.getReferredProperty()).orElse(true);
    }
    return true;
  }

  /** Returns the same for a definition; empty if there is none. Overridden ones are not pure. */
  private Optional<Boolean> isFunction(CallExp<?> call, ETypedElement member) {
    OCLExpression<EClassifier> definition = lowering.environment().bodyOf(member);
    EClassifier type = (EClassifier) call.getSource().getType();
    return definition == null
        ? Optional.empty()
        : Optional.of(lowering.overrides(type, member).isEmpty() && isFunction(definition));
  }

  private static Stream<EObject> parts(OCLExpression<EClassifier> expression) {
    List<EObject> parts = new ArrayList<>();
    Iterator<EObject> all = EcoreUtil.getAllContents(List.of(expression));
    all.forEachRemaining(parts::add);
    return parts.stream();
  }
}
