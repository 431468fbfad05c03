package dev.eventchain.ocl.lower;

import dev.eventchain.ocl.nodes.KeyedElements;
import dev.eventchain.ocl.nodes.LogicNodes;
import dev.eventchain.ocl.nodes.Node;
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
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.ocl.expressions.CallExp;
import org.eclipse.ocl.expressions.IteratorExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.PropertyCallExp;
import org.eclipse.ocl.expressions.Variable;
import org.eclipse.ocl.expressions.VariableExp;
import org.eclipse.ocl.utilities.PredefinedType;

/**
 * Finds loops that depend only on elements with a certain key: for all others, an equality in the
 * body alone decides the body.
 */
final class KeyLowering {

  private final BodyLowering body;
  private final Lowering lowering;

  /** The purity of expressions; false while it is being determined. */
  private final Map<OCLExpression<EClassifier>, Boolean> functions = new HashMap<>();

  KeyLowering(BodyLowering body, Lowering lowering) {
    this.body = body;
    this.lowering = lowering;
  }

  /**
   * Returns the source of a loop, reduced to the relevant elements if possible.
   *
   * @param variables the variable of the loop and its slot
   */
  Node source(
      IteratorExp<EClassifier, EParameter> loop,
      int code,
      Node source,
      Map<String, Integer> variables) {
    Variable<?, ?> variable = loop.getIterator().get(0);
    return deciding(loop.getBody(), code).stream()
        .flatMap(each -> keyed(each, variable, source, variables).stream())
        .findFirst()
        .orElse(source);
  }

  /** Returns the source with one comparison as the key, if that is possible. */
  private Optional<Node> keyed(
      OperationCallExp<EClassifier, EOperation> equality,
      Variable<?, ?> variable,
      Node source,
      Map<String, Integer> variables) {
    int slot = variables.get(variable.getName());
    OCLExpression<EClassifier> left = equality.getSource();
    OCLExpression<EClassifier> right = equality.getArgument().get(0);
    boolean leftIsKey = isKey(left, variable) && !reads(right, variable);
    boolean fits = leftIsKey || (isKey(right, variable) && !reads(left, variable));
    return fits && body.within(variables, equality) instanceof LogicNodes.Equality sides
        ? Optional.of(
            leftIsKey
                ? new KeyedElements(source, slot, sides.left(), sides.right())
                : new KeyedElements(source, slot, sides.right(), sides.left()))
        : Optional.empty();
  }

  /** Returns the comparisons that alone can make an element irrelevant. */
  private static List<OperationCallExp<EClassifier, EOperation>> deciding(
      OCLExpression<EClassifier> condition, int code) {
    return switch (code) {
      case PredefinedType.SELECT, PredefinedType.EXISTS, PredefinedType.ANY, PredefinedType.ONE ->
          equalities(condition, true);
      case PredefinedType.REJECT, PredefinedType.FOR_ALL -> equalities(condition, false);
      default -> List.of();
    };
  }

  /**
   * Returns the comparisons whose sides must be equal for the expression to be {@code truth}: where
   * they differ, it is the opposite, even if the rest of it is invalid.
   */
  @SuppressWarnings("unchecked") // Eclipse OCL's types have the metamodel as type arguments
  private static List<OperationCallExp<EClassifier, EOperation>> equalities(
      OCLExpression<EClassifier> expression, boolean truth) {
    if (!(expression instanceof OperationCallExp<?, ?>)) {
      return List.of();
    }
    var call = (OperationCallExp<EClassifier, EOperation>) expression;
    return switch (call.getOperationCode()) {
      case PredefinedType.EQUAL -> truth ? List.of(call) : List.of();
      case PredefinedType.NOT_EQUAL -> truth ? List.of() : List.of(call);
      case PredefinedType.NOT -> equalities(call.getSource(), !truth);
      case PredefinedType.AND -> truth ? ofBoth(call, true, true) : List.of();
      case PredefinedType.OR -> truth ? List.of() : ofBoth(call, false, false);
      case PredefinedType.IMPLIES -> truth ? List.of() : ofBoth(call, true, false);
      default -> List.of();
    };
  }

  private static List<OperationCallExp<EClassifier, EOperation>> ofBoth(
      OperationCallExp<EClassifier, EOperation> call, boolean left, boolean right) {
    List<OperationCallExp<EClassifier, EOperation>> all =
        new ArrayList<>(equalities(call.getSource(), left));
    all.addAll(equalities(call.getArgument().get(0), right));
    return all;
  }

  /** Returns whether the value depends on a variable and the model alone. */
  private boolean isKey(OCLExpression<EClassifier> expression, Variable<?, ?> variable) {
    return reads(expression, variable)
        && parts(expression)
            .allMatch(
                part ->
                    !(part instanceof VariableExp<?, ?> use)
                        || refers(use, variable)
                        || isWithin(use.getReferredVariable(), expression))
        && isFunction(expression);
  }

  private static boolean reads(OCLExpression<EClassifier> expression, Variable<?, ?> variable) {
    return parts(expression)
        .anyMatch(part -> part instanceof VariableExp<?, ?> use && refers(use, variable));
  }

  private static boolean isWithin(Object variable, OCLExpression<EClassifier> expression) {
    return variable instanceof EObject object && EcoreUtil.isAncestor((EObject) expression, object);
  }

  private static boolean refers(VariableExp<?, ?> use, Variable<?, ?> variable) {
    return use.getReferredVariable() == variable;
  }

  /**
   * Returns whether an expression is pure, including its calls. Recursive ones do not count: they
   * may not terminate for some elements.
   */
  private boolean isFunction(OCLExpression<EClassifier> expression) {
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
