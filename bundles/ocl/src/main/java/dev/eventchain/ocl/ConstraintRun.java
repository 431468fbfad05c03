package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.eclipse.emf.ecore.EObject;

/**
 * One invariant on all elements it is about, part by part and perhaps by several threads. The
 * findings are those of one thread that goes through the elements in order: at the first element at
 * which the invariant is given up, it ends.
 */
final class ConstraintRun {

  private static final long NOT_STARTED = 0;

  /** A finding and the index of its element. */
  private record Found(int index, Diagnostic diagnostic) {}

  private final OclConstraint constraint;
  private final List<EObject> elements;
  private final Duration timeLimit;
  private final Findings findings;
  private final AtomicLong deadline = new AtomicLong(NOT_STARTED);
  private final AtomicInteger givenUpAt = new AtomicInteger(Integer.MAX_VALUE);
  private final List<Found> found = new ArrayList<>();

  ConstraintRun(
      OclConstraint constraint, List<EObject> elements, Duration timeLimit, Findings findings) {
    this.constraint = constraint;
    this.elements = elements;
    this.timeLimit = timeLimit;
    this.findings = findings;
  }

  int size() {
    return elements.size();
  }

  /** How many elements were evaluated, and what that came to. */
  OclResult.Check check() {
    return new OclResult.Check(constraint, Math.min(elements.size(), givenUpAt.get() + 1L));
  }

  /** The findings, once all parts have been evaluated. */
  List<Diagnostic> findings() {
    return found.stream()
        .filter(each -> each.index() <= givenUpAt.get())
        .map(Found::diagnostic)
        .toList();
  }

  /** Evaluates the invariant on some of its elements; the interruption of the thread ends it. */
  void evaluate(int from, int to, Evaluation evaluation) {
    evaluation.setDeadline(startedUntil());
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

  /** What wants more memory than there is must not end the other constraints, too. */
  private Object valueFor(EObject element, Evaluation evaluation) {
    try {
      return constraint.evaluate(element, evaluation);
    } catch (OutOfMemoryError e) {
      return new Invalid("it needs more memory than there is", constraint.location(), true);
    }
  }

  /** The time limit counts from the first part that is begun. */
  private long startedUntil() {
    long now = System.nanoTime();
    long end = now + timeLimit.toNanos();
    deadline.compareAndSet(NOT_STARTED, end == NOT_STARTED ? end + 1 : end);
    return deadline.get();
  }

  private void add(int index, Object value, Evaluation evaluation) {
    EObject element = elements.get(index);
    Object known = value;
    if (isLimit(value) && !evaluation.ranOutOfTime()) {
      // The stack of this thread may be what was too small.
      known = DeepStack.call(() -> valueFor(element, evaluation));
    }
    if (Boolean.TRUE.equals(known)) {
      return;
    } else if (known instanceof Invalid invalid && invalid.limit()) {
      String reason =
          evaluation.ranOutOfTime() ? "it takes longer than " + text(timeLimit) : invalid.reason();
      give(index, findings.limit(constraint, element, reason));
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

  private synchronized void give(int index, Diagnostic diagnostic) {
    if (index < givenUpAt.get()) {
      givenUpAt.set(index);
      found.removeIf(each -> each.index() >= index);
      found.add(new Found(index, diagnostic));
    }
  }

  private static String text(Duration duration) {
    return duration.toMillis() % 1000 == 0
        ? duration.toSeconds() + " s"
        : duration.toMillis() + " ms";
  }
}
