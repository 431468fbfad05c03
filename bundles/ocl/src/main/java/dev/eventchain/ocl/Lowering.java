package dev.eventchain.ocl;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;

/**
 * Compiles the expressions of a language into trees of {@link Node}s, whose variables are slots of
 * an array. An expression is compiled once, when it is first evaluated, together with the
 * definitions it calls.
 */
final class Lowering {

  private final ExpressionLanguage language;
  private final Evaluator evaluator;
  private final ValueEnvironment environment;

  /** By the body. Only complete ones, except while one is being made. */
  private final Map<OCLExpression<EClassifier>, Lowered> definitions = new HashMap<>();

  /** The definitions that the expression at work has added. */
  private final List<OCLExpression<EClassifier>> added = new ArrayList<>();

  Lowering(ExpressionLanguage language) {
    this.language = language;
    Evaluation nowhere = Evaluation.over(List.of());
    this.evaluator = language.evaluator(nowhere, new LibraryCalls());
    this.environment = (ValueEnvironment) evaluator.getEvaluationEnvironment();
  }

  /** Lowers an expression. */
  synchronized Lowered lower(OCLExpression<EClassifier> expression) {
    added.clear();
    boolean done = false;
    try {
      Lowered result = new Lowered();
      new BodyLowering(this, null).lower(expression, result);
      done = true;
      return result;
    } finally {
      if (!done) {
        definitions.keySet().removeAll(added);
      }
    }
  }

  /** The lowered body of an operation; null if the operation has none. */
  Lowered definition(EOperation operation) {
    OCLExpression<EClassifier> body = language.bodyOf(operation);
    if (body == null) {
      return null;
    }
    List<String> parameters = new ArrayList<>();
    parameters.add("self");
    for (EParameter parameter : operation.getEParameters()) {
      parameters.add(parameter.getName());
    }
    return definition(body, parameters);
  }

  /** The lowered body of a property; null if the property has none. */
  Lowered definition(EStructuralFeature property) {
    OCLExpression<EClassifier> body = language.bodyOf(property);
    return body == null ? null : definition(body, List.of("self"));
  }

  /** The bodies that classes below the static type of a call's source give its operation. */
  List<VirtualCall.Implementation> overrides(OperationCallExp<EClassifier, EOperation> call) {
    List<VirtualCall.Implementation> found = new ArrayList<>();
    EOperation operation = call.getReferredOperation();
    if (call.getSource().getType() instanceof EClass type && operation != null) {
      for (EClass below : language.packages().classesBelow(type)) {
        for (EOperation other : language.environment().operationsOf(below)) {
          if (isOverride(other, operation)) {
            Lowered body = definition(other);
            if (body != null) {
              found.add(new VirtualCall.Implementation(below, body));
            }
          }
        }
      }
    }
    return found;
  }

  private static boolean isOverride(EOperation other, EOperation operation) {
    List<EParameter> parameters = other.getEParameters();
    List<EParameter> overridden = operation.getEParameters();
    boolean same =
        other != operation
            && other.getName() != null
            && other.getName().equals(operation.getName())
            && parameters.size() == overridden.size();
    for (int i = 0; same && i < parameters.size(); i++) {
      same = parameters.get(i).getEType() == overridden.get(i).getEType();
    }
    return same;
  }

  private Lowered definition(OCLExpression<EClassifier> body, List<String> parameters) {
    Lowered known = definitions.get(body);
    if (known == null) {
      known = new Lowered();
      definitions.put(body, known);
      added.add(body);
      new BodyLowering(this, parameters).lower(body, known);
    }
    return known;
  }

  /** The value of a literal of a primitive type or an enumeration, of null or of invalid. */
  Object constant(OCLExpression<EClassifier> literal) {
    return evaluator.visitExpression(literal);
  }

  ExpressionLanguage language() {
    return language;
  }

  /** Access to the model that does not depend on a run. */
  ValueEnvironment environment() {
    return environment;
  }
}
