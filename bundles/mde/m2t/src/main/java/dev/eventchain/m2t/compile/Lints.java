package dev.eventchain.m2t.compile;

import dev.eventchain.m2t.library.OperationTable;
import dev.eventchain.m2t.syntax.Problems;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.m2t.syntax.Syntax.Visibility;
import dev.eventchain.m2t.template.CallLibrary;
import dev.eventchain.m2t.template.Callable;
import dev.eventchain.m2t.template.Template;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.metamodel.Names;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.types.AnyType;
import org.eclipse.ocl.types.BagType;
import org.eclipse.ocl.types.OrderedSetType;
import org.eclipse.ocl.types.SetType;

/** Lint warnings about valid modules whose output may be unintended. */
public final class Lints {
  /**
   * A template or query.
   *
   * @param parameters the parameters as written in the file
   * @param inMain true if it is in the main module, which nothing imports
   */
  record Subject(
      Callable callable, List<Syntax.Variable> parameters, boolean inMain, Problems problems) {
    boolean isQuery() {
      return !(callable instanceof Template);
    }

    boolean isMain() {
      return inMain && callable instanceof Template template && template.isMain();
    }
  }

  private final List<Subject> subjects;
  private final Usage usage;

  private Lints(List<Subject> subjects, Usage usage) {
    this.subjects = subjects;
    this.usage = usage;
  }

  /** Warns of callables that are never called, and of parameters that are never used. */
  static void check(List<Subject> subjects, Usage usage) {
    Lints lints = new Lints(subjects, usage);
    Set<Callable> called = lints.called();
    for (Subject subject : subjects) {
      if (called.contains(subject.callable())) {
        lints.parameters(subject);
      } else {
        lints.neverCalled(subject);
      }
    }
  }

  /** Warns if the output depends on the order of a set or bag. */
  static void order(Optional<Expression> expression, String what, Problems problems, int start) {
    boolean warned =
        expression.isPresent()
            && isUnordered(expression.get().type())
            && !expression.get().holdsAtMostOne();
    if (warned) {
      order(expression.get().type(), what, problems, start);
    }
  }

  /** Warns of features whose values are computed by Java code that is not loaded. */
  static void computedInJava(Expression expression, Problems problems, int start) {
    for (EStructuralFeature feature : expression.computedInJava()) {
      problems.add(
          CompilerRules.FEATURE_JAVA,
          start,
          "This reads '%s' of %s, which only Java code computes: it always has its default."
              .formatted(feature.getName(), Names.of(feature.getEContainingClass())),
          "Give the feature a derivation in OCL, or compute it in a query.");
    }
  }

  /** Warns of separators between the elements of a set or bag. */
  static void separators(Expression expression, Problems problems, int start) {
    for (Expression.LibraryCall call : expression.libraryCalls()) {
      if (call.implementation() instanceof OperationTable.RowCall row
          && row.name().equals("sep")
          && isUnordered(call.sourceType())) {
        order(call.sourceType(), "->sep()", problems, start);
        return;
      }
    }
  }

  private static void order(EClassifier type, String what, Problems problems, int start) {
    problems.add(
        CompilerRules.LINT_UNORDERED,
        start,
        what + " outputs a " + type.getName() + ", which is unordered.",
        "Order it: ->sortedBy(...), or ->asSequence() where any order will do.");
  }

  private static boolean isUnordered(EClassifier type) {
    return type instanceof BagType<?, ?>
        || (type instanceof SetType<?, ?> && !(type instanceof OrderedSetType<?, ?>));
  }

  private Set<Callable> called() {
    boolean hasMain = subjects.stream().anyMatch(Subject::isMain);
    Deque<Callable> next = new ArrayDeque<>();
    for (Subject subject : subjects) {
      boolean open = subject.callable().visibility() != Visibility.PRIVATE;
      if (subject.isMain() || (open && !(subject.inMain() && hasMain))) {
        next.add(subject.callable());
      }
    }
    Set<Callable> called = new HashSet<>();
    while (!next.isEmpty()) {
      Callable each = next.remove();
      if (called.add(each)) {
        next.addAll(calledBy(each));
      }
    }
    return called;
  }

  private List<Callable> calledBy(Callable caller) {
    List<Callable> called = new ArrayList<>();
    for (Expression expression : usage.of(caller)) {
      for (Expression.LibraryCall call : expression.libraryCalls()) {
        if (call.implementation() instanceof CallLibrary.Call known) {
          called.addAll(known.candidates());
        }
      }
    }
    for (Subject subject : subjects) {
      if (subject.callable() instanceof Template other && other.overridden().contains(caller)) {
        called.add(other);
      }
    }
    if (caller instanceof Template template) {
      called.addAll(template.overridden());
    }
    return called;
  }

  private void neverCalled(Subject subject) {
    subject
        .problems()
        .add(
            CompilerRules.LINT_UNUSED,
            subject.callable().place().offset(),
            "The "
                + (subject.isQuery() ? "query" : "template")
                + " '"
                + subject.callable().name()
                + "' is never called.",
            subject.callable().visibility() == Visibility.PRIVATE
                ? "Remove it, or make it public for other modules."
                : "Remove it, or move it into a module that others import.");
  }

  private void parameters(Subject subject) {
    if (subject.isMain() || hasFixedParameters(subject.callable())) {
      return;
    }
    Set<String> used = new HashSet<>();
    usage.of(subject.callable()).forEach(each -> used.addAll(each.variableNames()));
    for (int i = 0; i < subject.parameters().size(); i++) {
      Callable.Parameter parameter = subject.callable().parameters().get(i);
      // The parameter may only serve as the receiver of calls.
      boolean receiver = i == 0 && (used.contains("self") || canBeElement(parameter.type()));
      if (!receiver && !used.contains(parameter.name())) {
        subject
            .problems()
            .add(
                CompilerRules.LINT_PARAMETER,
                subject.parameters().get(i).name().start(),
                "The parameter '"
                    + parameter.name()
                    + "' of '"
                    + subject.callable().name()
                    + "' is never used.",
                "Remove it here and in the calls.");
      }
    }
  }

  private static boolean canBeElement(EClassifier type) {
    return type instanceof EClass || type instanceof AnyType<?>;
  }

  /** Returns whether overloads or overriding templates fix the parameters. */
  private boolean hasFixedParameters(Callable callable) {
    return subjects.stream()
        .map(Subject::callable)
        .anyMatch(
            other ->
                other != callable
                    && other.parameters().size() == callable.parameters().size()
                    && (other.name().equals(callable.name())
                        || overrides(other, callable)
                        || overrides(callable, other)));
  }

  private static boolean overrides(Callable one, Callable other) {
    return one instanceof Template template && template.overridden().contains(other);
  }
}
