package dev.eventchain.constraints;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.ocl.evaluation.DeepStack;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.evaluation.TimeBudget;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * The evaluation of one invariant on all its elements, in parts that several threads may share. The
 * findings are the same as with one thread that checks the elements in order and ends where the
 * invariant is abandoned.
 */
final class ConstraintRun {

  /** A finding and the index of its element. */
  private record Found(int index, Diagnostic diagnostic) {}

  private final OclConstraint constraint;
  private final List<?> elements;
  private final TimeBudget budget;
  private final Findings findings;
  private final AtomicInteger givenUpAt = new AtomicInteger(Integer.MAX_VALUE);
  private final List<Found> found = new ArrayList<>();
  private long evaluations = Long.MAX_VALUE;

  ConstraintRun(OclConstraint constraint, List<?> elements, TimeBudget budget, Findings findings) {
    this.constraint = constraint;
    this.elements = elements;
    this.budget = budget;
    this.findings = findings;
  }

  int size() {
    return elements.size();
  }

  /** Returns the location of the invariant. */
  SourceLocation place() {
    return constraint.location();
  }

  /** Returns whether evaluating the invariant may need a deep stack. */
  boolean isRecursive() {
    return !elements.isEmpty() && DiagnosticException.at(place(), constraint::isRecursive);
  }

  /** Returns the invariant with the number of elements evaluated. */
  OclResult.Check check() {
    return new OclResult.Check(constraint, Math.min(elements.size(), evaluations));
  }

  /** Returns the findings, once all parts have been evaluated. */
  List<Diagnostic> findings() {
    return found.stream()
        .filter(each -> each.index() <= givenUpAt.get())
        .map(Found::diagnostic)
        .toList();
  }

  /** Evaluates the invariant on some of its elements; ends if the thread is interrupted. */
  void evaluate(int from, int to, Evaluation evaluation) {
    evaluation.withBudget(budget);
    if (evaluation.isOutOfTime() && !Thread.currentThread().isInterrupted()) {
      // Parts evaluated before or alongside this one have used up the time.
      give(from, from, findings.limit(constraint, elements, from, limit(budget.shortage())));
      return;
    }
    for (int i = from; i < to && i < givenUpAt.get(); i++) {
      Object value = valueFor(elements.get(i), evaluation);
      if (!Boolean.TRUE.equals(value)) {
        if (Thread.currentThread().isInterrupted()) {
          return;
        }
        add(i, value, evaluation);
      }
    }
  }

  /** Evaluates; running out of memory must not end the other constraints. */
  private Object valueFor(Object element, Evaluation evaluation) {
    try {
      return constraint.evaluate(element, evaluation);
    } catch (OutOfMemoryError e) {
      return limit("it needs more memory than is available");
    }
  }

  private Invalid limit(String reason) {
    return new Invalid(reason, constraint.location(), Invalid.Kind.COST);
  }

  private void add(int index, Object value, Evaluation evaluation) {
    Object element = elements.get(index);
    Object known = value;
    if (isLimit(value) && !evaluation.ranOutOfTime()) {
      // The stack of this thread may have been too small.
      known = DeepStack.call(() -> valueFor(element, evaluation));
    }
    if (Boolean.TRUE.equals(known)) {
      return;
    } else if (known instanceof Invalid invalid && invalid.limit()) {
      give(index, index + 1L, findings.limit(constraint, elements, index, invalid));
    } else if (known instanceof Boolean) {
      note(index, findings.violated(constraint, element, evaluation));
    } else {
      note(index, findings.undefined(constraint, element, known));
    }
  }

  private static boolean isLimit(Object value) {
    return value instanceof Invalid invalid && invalid.limit();
  }

  private synchronized void note(int index, Diagnostic diagnostic) {
    found.add(new Found(index, diagnostic));
  }

  private synchronized void give(int index, long evaluated, Diagnostic diagnostic) {
    if (index < givenUpAt.get()) {
      evaluations = evaluated;
      givenUpAt.set(index);
      found.removeIf(each -> each.index() >= index);
      found.add(new Found(index, diagnostic));
    }
  }
}
