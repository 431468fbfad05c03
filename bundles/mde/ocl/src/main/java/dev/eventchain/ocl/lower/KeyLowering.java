package dev.eventchain.ocl.lower;

import dev.eventchain.ocl.nodes.KeyedElements;
import dev.eventchain.ocl.nodes.LogicNodes;
import dev.eventchain.ocl.nodes.Node;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.ocl.expressions.IteratorExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.Variable;
import org.eclipse.ocl.utilities.PredefinedType;

/**
 * Finds loops that depend only on elements with a certain key: for all others, an equality in the
 * body alone decides the body.
 */
final class KeyLowering {

  private final BodyLowering body;
  private final Purity purity;

  KeyLowering(BodyLowering body, Purity purity) {
    this.body = body;
    this.purity = purity;
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
    boolean leftIsKey = isKey(left, variable) && !Purity.reads(right, variable);
    boolean fits = leftIsKey || (isKey(right, variable) && !Purity.reads(left, variable));
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
    return Purity.reads(expression, variable)
        && Purity.readsOnly(expression, variable)
        && purity.isFunction(expression);
  }
}
