package dev.eventchain.ocl.explain;

import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.tree.Asts;
import dev.eventchain.ocl.tree.SourceTexts;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.ocl.ecore.Constraint;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.Variable;
import org.eclipse.ocl.expressions.VariableExp;

/** Evaluates parts of a condition on an element and records their values. */
final class Probe {

  private final SubExpressions parts;
  private final Evaluation run;
  private final Facts facts = new Facts();
  private final Set<String> shown = new HashSet<>(Set.of("self"));

  Probe(SubExpressions parts, Evaluation run) {
    this.parts = parts;
    this.run = run;
  }

  Facts facts() {
    return facts;
  }

  Constraint definition(Object feature) {
    return feature == null ? null : parts.definition(feature);
  }

  /** Returns the value of a part; an {@link Invalid} also if the time is over. */
  Object evaluate(OCLExpression<EClassifier> part) {
    return parts.evaluate(part, run);
  }

  /** Returns the elements of a part that is a collection; none if it has no value. */
  Collection<?> elements(OCLExpression<EClassifier> part) {
    return evaluate(part) instanceof Collection<?> elements ? elements : List.of();
  }

  boolean outOfTime() {
    return run.isOutOfTime();
  }

  /** Runs an action while a variable has a value. */
  void with(String variable, Object value, Runnable action) {
    run.bind(variable, value);
    try {
      action.run();
    } finally {
      run.unbind(variable);
    }
  }

  /** Runs an action while variables have values; not if their numbers differ. */
  void withAll(List<Variable<EClassifier, EParameter>> variables, List<?> values, Runnable action) {
    if (variables.size() != values.size()) {
      return;
    } else if (variables.isEmpty()) {
      action.run();
      return;
    }
    int last = variables.size() - 1;
    with(
        variables.get(last).getName(),
        values.get(last),
        () -> withAll(variables.subList(0, last), values.subList(0, last), action));
  }

  /** Runs an action while the values of variables are known to the reader. */
  void showing(Collection<String> variables, Runnable action) {
    List<String> added = new ArrayList<>(variables);
    added.removeIf(shown::contains);
    shown.addAll(added);
    action.run();
    added.forEach(shown::remove);
  }

  /**
   * Records the value of a part, unless the reader sees it already.
   *
   * @return true if the reader knows it now; false for a literal or if the time is over
   */
  boolean tell(OCLExpression<EClassifier> part) {
    String text = SourceTexts.of(part);
    if (isShown(part)) {
      return true;
    } else if (facts.full() || text.isEmpty() || Asts.isLiteral(part)) {
      return facts.full();
    }
    Object value = evaluate(part);
    boolean limit = value instanceof Invalid invalid && invalid.limit();
    if (!limit) {
      facts.add(text, value);
    }
    return !limit;
  }

  private boolean isShown(OCLExpression<EClassifier> part) {
    return part instanceof VariableExp<?, ?> use
        && use.getReferredVariable() != null
        && shown.contains(use.getReferredVariable().getName());
  }
}
