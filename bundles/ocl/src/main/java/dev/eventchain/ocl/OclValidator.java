package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.Function;
import org.eclipse.emf.common.util.TreeIterator;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * Evaluates rules on models. The findings are: {@code ocl.violated} for an element for which an
 * invariant is false, {@code ocl.undefined} where it is neither true nor false, {@code ocl.limit}
 * for an invariant that recurses without end or takes too long, and {@code ocl.nothing-evaluated}
 * if there was nothing to evaluate, which is no pass.
 */
public final class OclValidator {

  /** How long one invariant may take on a whole model. */
  private static final Duration TIME_LIMIT = Duration.ofSeconds(60);

  /** Room for the deepest recursion that {@link Evaluation} allows; only used as far as needed. */
  private static final long STACK_BYTES = 512L << 20;

  private final OclRules rules;
  private final Duration timeLimit;

  private OclValidator(OclRules rules, Duration timeLimit) {
    this.rules = rules;
    this.timeLimit = timeLimit;
  }

  /** A validator that gives each invariant a minute for a whole model. */
  public static OclValidator of(OclRules rules) {
    return new OclValidator(rules, TIME_LIMIT);
  }

  /** The same validator with another limit for each invariant on a whole model. */
  public OclValidator withTimeLimit(Duration limit) {
    return new OclValidator(rules, limit);
  }

  /**
   * Evaluates every invariant on every element it is about.
   *
   * @param roots the roots of the models, whose elements are checked; {@code allInstances()} covers
   *     their whole resource sets
   * @param locator tells where an element stands
   * @return the findings, those of the rules themselves included
   */
  public OclResult validate(
      Collection<? extends EObject> roots, Function<EObject, SourceLocation> locator) {
    FutureTask<OclResult> task = new FutureTask<>(() -> new Run(roots, locator).validate());
    Thread thread = new Thread(null, task, "eventchain-ocl", STACK_BYTES);
    thread.setDaemon(true);
    thread.start();
    try {
      return task.get();
    } catch (InterruptedException e) {
      thread.interrupt();
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted while validating", e);
    } catch (ExecutionException e) {
      throw e.getCause() instanceof RuntimeException cause
          ? cause
          : new IllegalStateException(e.getCause());
    }
  }

  /** As {@link #validate(Collection, Function)} with the default limit. */
  public static OclResult validate(
      OclRules rules,
      Collection<? extends EObject> roots,
      Function<EObject, SourceLocation> locator) {
    return of(rules).validate(roots, locator);
  }

  private final class Run {
    private final List<EObject> elements;
    private final Evaluation evaluation;
    private final Findings findings;
    private final List<Diagnostic> found = new ArrayList<>();
    private final List<OclResult.Check> checks = new ArrayList<>();

    Run(Collection<? extends EObject> roots, Function<EObject, SourceLocation> locator) {
      this.findings = new Findings(locator);
      this.elements = elementsOf(roots);
      this.evaluation = Evaluation.over(roots);
    }

    private static List<EObject> elementsOf(Collection<? extends EObject> roots) {
      Set<EObject> found = new LinkedHashSet<>();
      TreeIterator<EObject> objects = EcoreUtil.getAllContents(roots, true);
      while (objects.hasNext()) {
        found.add(objects.next());
      }
      return new ArrayList<>(found);
    }

    OclResult validate() {
      for (OclConstraint constraint : rules.constraints()) {
        checks.add(new OclResult.Check(constraint, evaluate(constraint)));
      }
      found.sort(null);
      List<Diagnostic> all = new ArrayList<>(rules.diagnostics());
      all.addAll(found);
      if (checks.stream().allMatch(check -> check.evaluations() == 0)) {
        all.add(nothingEvaluated());
      }
      return new OclResult(elements.size(), checks, all);
    }

    /** Evaluates an invariant on its elements and says on how many. */
    private long evaluate(OclConstraint constraint) {
      long evaluations = 0;
      long deadline = System.nanoTime() + timeLimit.toNanos();
      for (EObject element : elements) {
        if (constraint.context().isInstance(element)) {
          long left = Math.max(0, deadline - System.nanoTime());
          evaluation.withTimeLimit(Duration.ofNanos(left));
          evaluations++;
          Object value = constraint.evaluate(element, evaluation);
          if (value instanceof Invalid invalid && invalid.limit()) {
            String reason =
                evaluation.ranOutOfTime()
                    ? "it takes longer than " + text(timeLimit)
                    : invalid.reason();
            found.add(findings.limit(constraint, element, reason));
            return evaluations;
          } else if (!Boolean.TRUE.equals(value)) {
            left = Math.max(0, deadline - System.nanoTime());
            boolean violated = value instanceof Boolean;
            found.add(
                violated
                    ? findings.violated(constraint, element, evaluation, Duration.ofNanos(left))
                    : findings.undefined(constraint, element, value));
          }
        }
      }
      return evaluations;
    }

    private Diagnostic nothingEvaluated() {
      return Diagnostic.error(
              "ocl.nothing-evaluated",
              "Nothing was checked: "
                  + rules.constraints().size()
                  + " constraints, "
                  + elements.size()
                  + " elements, and none that a constraint is about.",
              SourceLocation.NONE)
          .withHint("Give rules for the classes of this model.");
    }
  }

  private static String text(Duration duration) {
    return duration.toMillis() % 1000 == 0
        ? duration.toSeconds() + " s"
        : duration.toMillis() + " ms";
  }
}
