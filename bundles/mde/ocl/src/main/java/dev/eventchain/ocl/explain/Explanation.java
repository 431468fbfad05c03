package dev.eventchain.ocl.explain;

import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.tree.Asts;
import java.util.List;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.ecore.Constraint;
import org.eclipse.ocl.expressions.BooleanLiteralExp;
import org.eclipse.ocl.expressions.IfExp;
import org.eclipse.ocl.expressions.IteratorExp;
import org.eclipse.ocl.expressions.LetExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.PropertyCallExp;
import org.eclipse.ocl.expressions.Variable;
import org.eclipse.ocl.utilities.ExpressionInOCL;
import org.eclipse.ocl.utilities.PredefinedType;

/**
 * Finds the values that decide a condition for an element: descends through {@code and}, {@code
 * implies}, {@code if}, {@code forAll} and the like to the decisive parts, and names the values
 * they compare. Evaluates the parts again, within a time limit.
 */
public final class Explanation {

  private final Probe probe;
  private final Facts facts;
  private boolean insideDefinition;

  private Explanation(Probe probe) {
    this.probe = probe;
    this.facts = probe.facts();
  }

  /**
   * Explains why a condition is false for the element that the run has bound to {@code self}.
   *
   * @param run the evaluation; its time limit applies to the explanation, too
   * @return such as {@code self.pages is 3}; empty if there is no explanation
   */
  public static String whyFalse(
      OCLExpression<EClassifier> condition, SubExpressions parts, Evaluation run) {
    Probe probe = new Probe(parts, run);
    new Explanation(probe).explain(condition, false);
    return probe.facts().text();
  }

  /** Explains the value of a part of the condition. */
  private void explain(OCLExpression<EClassifier> node, boolean actual) {
    if (facts.full()) {
      return;
    } else if (node instanceof OperationCallExp<?, ?>) {
      explainCall(cast(node), actual);
    } else if (node instanceof IteratorExp<?, ?>) {
      explainIterator(cast(node), actual);
    } else if (node instanceof IfExp<EClassifier> choice) {
      explainChoice(choice, actual);
    } else if (node instanceof LetExp<?, ?>) {
      LetExp<EClassifier, EParameter> let = cast(node);
      Variable<EClassifier, EParameter> variable = let.getVariable();
      Object value = probe.evaluate(variable.getInitExpression());
      probe.with(variable.getName(), value, () -> explain(let.getIn(), actual));
    } else if (node instanceof PropertyCallExp<?, ?>) {
      PropertyCallExp<EClassifier, EStructuralFeature> call = cast(node);
      probe.tell(node);
      explainDefinition(
          probe.definition(call.getReferredProperty()), call.getSource(), List.of(), actual);
    } else if (!(node instanceof BooleanLiteralExp<?>)) {
      probe.tell(node);
    }
  }

  private void explainCall(OperationCallExp<EClassifier, EOperation> call, boolean actual) {
    OCLExpression<EClassifier> left = call.getSource();
    if (!Asts.isLogical(call)) {
      explainQuestion(call, actual);
    } else if (call.getOperationCode() == PredefinedType.NOT) {
      explain(left, !actual);
    } else if (call.getOperationCode() == PredefinedType.IMPLIES) {
      explainImplies(left, call.getArgument().get(0), actual);
    } else {
      // The false operands make an 'and' false; all operands of a false 'or' are false.
      boolean both = call.getOperationCode() == PredefinedType.XOR;
      for (OCLExpression<EClassifier> operand : List.of(left, call.getArgument().get(0))) {
        if (probe.evaluate(operand) instanceof Boolean value && (both || value == actual)) {
          explain(operand, value);
        }
      }
    }
  }

  private void explainImplies(
      OCLExpression<EClassifier> left, OCLExpression<EClassifier> right, boolean actual) {
    int before = facts.size();
    if (actual && Boolean.FALSE.equals(probe.evaluate(left))) {
      explain(left, false);
    } else {
      explain(right, actual);
      if (facts.size() == before) {
        explain(left, true);
      }
    }
  }

  private void explainChoice(IfExp<EClassifier> choice, boolean actual) {
    if (probe.evaluate(choice.getCondition()) instanceof Boolean holds) {
      int before = facts.size();
      explain(holds ? choice.getThenExpression() : choice.getElseExpression(), actual);
      if (facts.size() == before) {
        explain(choice.getCondition(), holds);
      }
    }
  }

  /** Explains a comparison, a predicate on a collection, or the call of a definition. */
  private void explainQuestion(OperationCallExp<EClassifier, EOperation> call, boolean actual) {
    Constraint definition = probe.definition(call.getReferredOperation());
    if (definition != null) {
      probe.tell(call);
      explainDefinition(definition, call.getSource(), call.getArgument(), actual);
      return;
    }
    boolean told = probe.tell(Asts.withoutImplicitSet(call.getSource()));
    for (OCLExpression<EClassifier> argument : call.getArgument()) {
      told |= probe.tell(argument);
    }
    if (!told) {
      probe.tell(call);
    }
  }

  /**
   * Explains a definition called on {@code self}, but not those that it uses, where the same
   * expressions would have other values.
   */
  private void explainDefinition(
      Constraint definition,
      OCLExpression<EClassifier> source,
      List<OCLExpression<EClassifier>> arguments,
      boolean actual) {
    if (definition == null
        || definition.getSpecification() == null
        || !Asts.isSelf(source)
        || insideDefinition) {
      return;
    }
    ExpressionInOCL<EClassifier, EParameter> body = definition.getSpecification();
    List<Object> values = arguments.stream().map(probe::evaluate).toList();
    insideDefinition = true;
    probe.withAll(
        body.getParameterVariable(), values, () -> explain(body.getBodyExpression(), actual));
    insideDefinition = false;
  }

  private void explainIterator(IteratorExp<EClassifier, EParameter> loop, boolean actual) {
    Witnesses witnesses = new Witnesses(probe, loop, this::explain);
    boolean decided =
        switch (loop.getName()) {
          case "forAll" -> !actual && witnesses.tellFirst(false);
          case "exists" -> actual && witnesses.tellFirst(true);
          case "isUnique" -> !actual && witnesses.tellEqual();
          case "one" -> !actual && witnesses.tellAll();
          default -> false;
        };
    if (!decided) {
      probe.tell(Asts.withoutImplicitSet(loop.getSource()));
    }
  }

  /** Casts a node; at run time, Eclipse OCL's node types imply the type arguments. */
  @SuppressWarnings({"unchecked", "TypeParameterUnusedInFormals"})
  private static <T extends OCLExpression<EClassifier>> T cast(OCLExpression<EClassifier> node) {
    return (T) node;
  }
}
