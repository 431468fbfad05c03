package dev.eventchain.constraints;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.ocl.Evaluations;
import dev.eventchain.ocl.evaluation.DeepStack;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.TimeBudget;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import org.eclipse.emf.ecore.EObject;

/**
 * Evaluates rules on models. {@code ocl.violated} reports an element for which an invariant is
 * false, and {@code ocl.undefined} one for which it is neither true nor false. {@code ocl.limit}
 * reports an invariant that recurses endlessly or takes too long. {@code ocl.nothing-evaluated}
 * says that there was nothing to evaluate, which is not a pass.
 *
 * <p>A large model is evaluated by several threads; the findings are those of one. The references
 * of such a model must be resolved already: its files are not loaded while it is evaluated.
 */
public final class OclValidator {

  /**
   * The processor time of one invariant on a whole model, unless stated otherwise. Twenty of them
   * on half a million elements take a few seconds in all.
   */
  public static final Duration TIME_LIMIT = Duration.ofSeconds(30);

  /** Number of invariants that may use up their time. */
  private static final int SLOW_CONSTRAINTS = 4;

  /** Number of evaluations below which threads cost more than they save. */
  private static final long FEW_EVALUATIONS = 10_000;

  private static final int LARGEST_PART = 4096;
  private static final int SMALLEST_PART = 256;

  /** Some elements of a constraint. */
  private record Part(ConstraintRun run, int from, int to) {}

  private final OclRules rules;
  private final Duration timeLimit;
  private final int threads;
  private final TimeBudget.Clock clock;

  private OclValidator(OclRules rules, Duration timeLimit, int threads, TimeBudget.Clock clock) {
    this.rules = rules;
    this.timeLimit = timeLimit;
    this.threads = threads;
    this.clock = clock;
  }

  /**
   * Returns a validator that gives each invariant 30 seconds of processor time for a whole model,
   * and uses all processors for a large one.
   */
  public static OclValidator of(OclRules rules) {
    int processors = Runtime.getRuntime().availableProcessors();
    return new OclValidator(rules, TIME_LIMIT, processors, TimeBudget.Clock.SYSTEM);
  }

  /**
   * Returns the same validator with another limit.
   *
   * @param limit the processor time of each invariant on a whole model; all of them together may
   *     take four times as long
   */
  public OclValidator withTimeLimit(Duration limit) {
    return new OclValidator(rules, limit, threads, clock);
  }

  /** Returns the same validator with other clocks. */
  OclValidator withClock(TimeBudget.Clock other) {
    return new OclValidator(rules, timeLimit, threads, other);
  }

  /**
   * Returns the same validator with another number of threads for large models.
   *
   * @throws IllegalArgumentException if it is less than one
   */
  OclValidator withThreads(int number) {
    if (number < 1) {
      throw new IllegalArgumentException(number + " threads");
    }
    return new OclValidator(rules, timeLimit, number, clock);
  }

  /**
   * Evaluates every invariant on all its elements.
   *
   * @param roots the roots of the models, whose elements are checked; {@code allInstances()} covers
   *     their whole resource sets
   * @param locator returns the location of an element; called for one finding at a time
   * @return the findings, including those of the rules themselves
   * @throws IllegalStateException if the thread is interrupted meanwhile
   */
  public OclResult validate(
      Collection<? extends EObject> roots, Function<EObject, SourceLocation> locator) {
    Evaluation evaluation = Evaluations.over(roots);
    int size = evaluation.elements().size();
    ModelElements elements = new ModelElements(evaluation);
    Findings findings = new Findings(locator);
    TimeBudget whole =
        TimeBudget.of(
            "all constraints together take", timeLimit.multipliedBy(SLOW_CONSTRAINTS), clock);
    List<ConstraintRun> runs = new ArrayList<>();
    for (OclConstraint constraint : rules.constraints()) {
      List<?> instances = elements.subjectsOf(constraint.context());
      runs.add(new ConstraintRun(constraint, instances, whole.part(timeLimit), findings));
    }
    evaluate(runs, evaluation);

    List<Diagnostic> all = new ArrayList<>();
    runs.forEach(run -> all.addAll(run.findings()));
    all.sort(null);
    all.addAll(0, rules.diagnostics());
    List<OclResult.Check> checks = runs.stream().map(ConstraintRun::check).toList();
    if (checks.stream().allMatch(check -> check.evaluations() == 0)) {
      all.add(Findings.nothingEvaluated(rules, size));
    }
    return new OclResult(size, checks, all);
  }

  private void evaluate(List<ConstraintRun> runs, Evaluation evaluation) {
    long evaluations = runs.stream().mapToLong(ConstraintRun::size).sum();
    int workers = evaluations < FEW_EVALUATIONS ? 1 : threads;
    List<Part> parts = new ArrayList<>();
    for (ConstraintRun run : runs) {
      int size = workers == 1 ? Math.max(1, run.size()) : partSize(run.size(), workers);
      for (int from = 0; from < run.size(); from += size) {
        parts.add(new Part(run, from, Math.min(run.size(), from + size)));
      }
    }
    AtomicInteger next = new AtomicInteger();
    Runnable work =
        () -> {
          Evaluation own = evaluation.fork();
          for (int i = next.getAndIncrement(); i < parts.size(); i = next.getAndIncrement()) {
            if (Thread.currentThread().isInterrupted()) {
              return;
            }
            Part part = parts.get(i);
            DiagnosticException.runAt(
                part.run().place(), () -> part.run().evaluate(part.from(), part.to(), own));
          }
        };
    if (workers > 1 || runs.stream().anyMatch(ConstraintRun::isRecursive)) {
      DeepStack.runAll(Collections.nCopies(workers, work));
    } else {
      runHere(work);
    }
  }

  private static void runHere(Runnable work) {
    work.run();
    if (Thread.currentThread().isInterrupted()) {
      throw new IllegalStateException("interrupted while evaluating");
    }
  }

  /** Returns a size so small that all workers end at about the same time. */
  private static int partSize(int elements, int workers) {
    return Math.max(SMALLEST_PART, Math.min(LARGEST_PART, elements / (workers * 4) + 1));
  }

  /** As {@link #validate(Collection, Function)} with the default limit. */
  public static OclResult validate(
      OclRules rules,
      Collection<? extends EObject> roots,
      Function<EObject, SourceLocation> locator) {
    return of(rules).validate(roots, locator);
  }
}
