package dev.eventchain.constraints;

import dev.eventchain.constraints.OclConstraint.Verdict;
import dev.eventchain.ocl.evaluation.DeepStack;
import dev.eventchain.ocl.evaluation.TimeBudget;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;

/**
 * Searches one model that satisfies a constraint and one that violates it: the given model, and
 * changes of the features that the constraint reads, one and then two at a time. A constraint
 * without both is trivial.
 */
public final class ConstraintProof {
  /**
   * Maximal number of changed models per constraint: more than any useful constraint needed, and
   * tried within a second or two.
   */
  private static final int MOST_MODELS = 4000;

  /** Limit of processor time for a proof. Some constraints are slow on each model. */
  private static final Duration TIME_LIMIT = Duration.ofSeconds(30);

  private final OclConstraint constraint;
  private final TimeBudget budget;
  private boolean holds;
  private boolean fails;
  private int models;

  private ConstraintProof(OclConstraint constraint, TimeBudget budget) {
    this.constraint = constraint;
    this.budget = budget;
  }

  /** Returns the objection to the constraint; empty if both models were found. */
  public static Optional<String> objection(OclConstraint constraint, List<EObject> roots) {
    return objection(constraint, roots, TimeBudget.of(TIME_LIMIT));
  }

  /**
   * As {@link #objection(OclConstraint, List)}.
   *
   * @param budget the time that the search may take
   */
  public static Optional<String> objection(
      OclConstraint constraint, List<EObject> roots, TimeBudget budget) {
    ConstraintProof proof = new ConstraintProof(constraint, budget);
    proof.search(ModelCopy.of(roots));
    if (proof.holds && proof.fails) {
      return Optional.empty();
    }
    String within = proof.budget.isSpent() ? " in the time available" : "";
    String missing = proof.holds ? "fails" : "holds";
    return Optional.of(
        "No model was found%s for which '%s' %s".formatted(within, constraint.name(), missing));
  }

  /**
   * Returns whether no change of a model violates a constraint; false also if the time runs out
   * before all changes have been tried.
   *
   * @param roots the model, which is not modified
   * @param limit the processor time that the search may take
   */
  public static boolean neverFails(
      OclConstraint constraint, List<? extends EObject> roots, Duration limit) {
    if (!(constraint.context() instanceof EClass)) {
      return constraint.holdsForAnything(); // values of data types are never changed here
    }
    ConstraintProof proof = new ConstraintProof(constraint, TimeBudget.of(limit));
    proof.holds = true; // Whether it can hold is of no interest here.
    return DeepStack.call(
        () -> {
          proof.search(ModelCopy.of(List.copyOf(roots)));
          return !proof.fails && !proof.budget.isSpent();
        });
  }

  private void search(ModelCopy model) {
    judge(model);
    List<ModelChange> changes = ModelChange.all(model, constraint);
    tryAll(model, changes);
    for (ModelChange first : changes) {
      if (isDecided()) {
        return;
      }
      ModelCopy changed = model.with(first);
      tryAll(changed, ModelChange.all(changed, constraint));
    }
  }

  private void tryAll(ModelCopy model, List<ModelChange> changes) {
    for (ModelChange change : changes) {
      if (isDecided()) {
        return;
      }
      judge(model.with(change));
    }
  }

  private boolean isDecided() {
    return (holds && fails) || models >= MOST_MODELS || budget.isSpent();
  }

  private void judge(ModelCopy model) {
    models++;
    boolean all = true;
    boolean any = false;
    if (!(constraint.context() instanceof EClass type)) {
      return; // values of data types are never changed here
    }
    for (EObject element : model.instancesOf(type)) {
      Verdict verdict = constraint.evaluate(element, budget);
      fails |= verdict == Verdict.FALSE;
      all &= verdict == Verdict.TRUE;
      any = true;
    }
    holds |= any && all;
  }
}
