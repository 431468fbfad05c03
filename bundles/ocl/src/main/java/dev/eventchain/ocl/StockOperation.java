package dev.eventchain.ocl;

import java.util.List;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.ocl.ecore.EcoreFactory;
import org.eclipse.ocl.ecore.TypeExp;
import org.eclipse.ocl.ecore.Variable;
import org.eclipse.ocl.ecore.VariableExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;

/**
 * Applies an operation of the standard library to given values by means of {@link Evaluator}: for
 * values of unusual Java types and for operations that are not worth a node of their own.
 */
final class StockOperation {

  private static final List<String> OPERANDS = List.of("(source)", "(argument 1)", "(argument 2)");

  private final ExpressionLanguage language;
  private final OperationCallExp<EClassifier, EOperation> original;

  /** A call whose source and arguments are variables; made when first needed, which is seldom. */
  private volatile OperationCallExp<EClassifier, EOperation> template;

  /**
   * Prepares an operation.
   *
   * @param original a call of it, whose source and arguments do not matter but for their types
   */
  StockOperation(ExpressionLanguage language, OperationCallExp<EClassifier, EOperation> original) {
    this.language = language;
    this.original = original;
  }

  private OperationCallExp<EClassifier, EOperation> template() {
    OperationCallExp<EClassifier, EOperation> known = template;
    if (known == null) {
      known = EcoreFactory.eINSTANCE.createOperationCallExp();
      known.setReferredOperation(original.getReferredOperation());
      known.setOperationCode(original.getOperationCode());
      known.setType(original.getType());
      known.setSource(operand(0, original.getSource()));
      for (OCLExpression<EClassifier> argument : original.getArgument()) {
        known.getArgument().add(operand(known.getArgument().size() + 1, argument));
      }
      template = known;
    }
    return known;
  }

  private static OCLExpression<EClassifier> operand(int index, OCLExpression<EClassifier> operand) {
    if (operand instanceof TypeExp type) {
      return EcoreUtil.copy(type);
    }
    Variable variable = EcoreFactory.eINSTANCE.createVariable();
    variable.setName(OPERANDS.get(index));
    variable.setType(operand.getType());
    VariableExp use = EcoreFactory.eINSTANCE.createVariableExp();
    use.setReferredVariable(variable);
    use.setType(operand.getType());
    return use;
  }

  /** The result for these values. */
  Object apply(Frame frame, Object... values) {
    ValueStack stack = frame.run.values();
    int height = stack.size();
    for (int i = 0; i < values.length; i++) {
      stack.push(OPERANDS.get(i), values[i]);
    }
    try {
      return language.evaluator(frame.run, frame.calls()).visitExpression(template());
    } finally {
      stack.truncate(height);
    }
  }

  /** A node that always applies the operation so. */
  static final class Apply extends Node {
    private final StockOperation operation;
    private final Node[] operands;

    Apply(StockOperation operation, Node... operands) {
      this.operation = operation;
      this.operands = operands;
    }

    @Override
    Object evaluate(Frame frame) {
      return operation.apply(frame, DefinitionNodes.evaluate(operands, frame));
    }
  }
}
