package dev.eventchain.ocl.explain;

import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.metamodel.ValueTexts;
import dev.eventchain.ocl.tree.SafeNavigation;
import dev.eventchain.ocl.tree.SourceTexts;
import dev.eventchain.ocl.values.Values;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.ocl.expressions.IteratorExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.Variable;

/** Finds the elements that decide an iterator, such as the one for which a forAll fails. */
final class Witnesses {

  /** Explains why a body has its value. */
  @FunctionalInterface
  interface Explainer {
    void explain(OCLExpression<EClassifier> body, boolean actual);
  }

  private final Probe probe;
  private final IteratorExp<EClassifier, EParameter> loop;
  private final OCLExpression<EClassifier> body;
  private final List<Variable<EClassifier, EParameter>> variables;
  private final Explainer explainer;
  private boolean found;

  Witnesses(Probe probe, IteratorExp<EClassifier, EParameter> loop, Explainer explainer) {
    this.probe = probe;
    this.loop = loop;
    this.body = loop.getBody();
    this.variables = loop.getIterator();
    this.explainer = explainer;
  }

  /** Reports the first elements for which the body has a value; false if there are none. */
  boolean tellFirst(boolean wanted) {
    search(elements(), new ArrayList<>(), wanted);
    return found;
  }

  /** Returns the elements that the loop sees. */
  private Collection<?> elements() {
    Collection<?> all = probe.elements(loop.getSource());
    return SafeNavigation.isSafe(loop) ? all.stream().filter(Objects::nonNull).toList() : all;
  }

  /** Binds the iterator variables from the first on, as the evaluation does. */
  private void search(Collection<?> elements, List<Object> values, boolean wanted) {
    if (values.size() == variables.size()) {
      if (Boolean.valueOf(wanted).equals(probe.evaluate(body))) {
        found = true;
        tell(values, () -> explainer.explain(body, wanted));
      }
      return;
    }
    String variable = variables.get(values.size()).getName();
    for (Object element : elements) {
      if (found || probe.outOfTime()) {
        return;
      }
      values.add(element);
      probe.with(variable, element, () -> search(elements, values, wanted));
      values.remove(values.size() - 1);
    }
  }

  private void tell(List<Object> values, Runnable explanation) {
    List<String> names = new ArrayList<>();
    List<String> bindings = new ArrayList<>();
    List<String> facts = new ArrayList<>();
    for (int i = 0; i < values.size(); i++) {
      String value = ValueTexts.of(values.get(i));
      boolean named = isNamed(variables.get(i));
      bindings.add(named ? variables.get(i).getName() + " = " + value : value);
      if (named) {
        names.add(variables.get(i).getName());
        facts.add(variables.get(i).getName() + " is " + value);
      }
    }
    String otherwise =
        facts.isEmpty()
            ? SourceTexts.of(body) + " for " + bindings.get(0)
            : String.join(" and ", facts);
    probe.showing(
        names,
        () -> probe.facts().group("for " + String.join(" and ", bindings), otherwise, explanation));
  }

  /** Returns whether an iterator is written; an implicit one has no position. */
  private static boolean isNamed(Variable<?, ?> variable) {
    return variable.getStartPosition() >= 0;
  }

  /** Reports the first two elements for which the body has the same value. */
  boolean tellEqual() {
    Map<Object, Object> first = new HashMap<>();
    for (Object element : elements()) {
      if (probe.outOfTime()) {
        return false;
      }
      Object value = valueFor(element);
      Object key = Values.key(value);
      if (first.containsKey(key) && !(value instanceof Invalid)) {
        probe
            .facts()
            .add(
                SourceTexts.of(body)
                    + " "
                    + ValueTexts.predicate(value)
                    + " for "
                    + ValueTexts.of(first.get(key))
                    + " and for "
                    + ValueTexts.of(element));
        return true;
      }
      first.put(key, element);
    }
    return false;
  }

  private Object valueFor(Object element) {
    Object[] value = new Object[1];
    probe.with(variables.get(0).getName(), element, () -> value[0] = probe.evaluate(body));
    return value[0];
  }

  /** Reports the elements that satisfy the body of a {@code one}; false if none does. */
  boolean tellAll() {
    List<Object> all = new ArrayList<>();
    for (Object element : elements()) {
      if (probe.outOfTime()) {
        return false;
      }
      if (Boolean.TRUE.equals(valueFor(element))) {
        all.add(element);
      }
    }
    if (!all.isEmpty()) {
      probe
          .facts()
          .add(
              SourceTexts.of(body)
                  + " is true for "
                  + all.size()
                  + " elements: "
                  + ValueTexts.of(all));
    }
    return !all.isEmpty();
  }
}
