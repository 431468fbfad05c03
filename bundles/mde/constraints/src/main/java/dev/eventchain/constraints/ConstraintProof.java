package dev.eventchain.constraints;

import dev.eventchain.constraints.OclConstraint.Verdict;
import dev.eventchain.ocl.Expression.Navigation;
import dev.eventchain.ocl.evaluation.DeepStack;
import dev.eventchain.ocl.evaluation.TimeBudget;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;

/**
 * Searches one model that satisfies a constraint and one that violates it: the given model, changes
 * of the features that the constraint reads, one and then two at a time, and then several at
 * random. A search that finds none shows nothing, since the right combination may not have been
 * tried.
 */
public final class ConstraintProof {
  /**
   * Maximal number of changed models per constraint: more than any useful constraint needed, and
   * tried within a second or two.
   */
  private static final int MOST_MODELS = 4000;

  /** Number of models with random changes. */
  private static final int MOST_RANDOM = 2000;

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

  /**
   * The objection to a constraint.
   *
   * @param holds true if a model satisfies it, so that only one that violates it is missing
   * @param doubtful true if the right model may only not have been tried: it holds, and depends on
   *     conditions that may not have come true
   * @param unknown texts in it that are no value in the model, such as misspelt names, if it holds
   * @param message a sentence without its full stop
   */
  public record Objection(boolean holds, boolean doubtful, List<String> unknown, String message) {
    /** Copies the list. */
    public Objection {
      unknown = List.copyOf(unknown);
    }
  }

  /** Returns the objection to the constraint; empty if both models were found. */
  public static Optional<Objection> objection(OclConstraint constraint, List<EObject> roots) {
    return objection(constraint, roots, TimeBudget.of(TIME_LIMIT));
  }

  /**
   * As {@link #objection(OclConstraint, List)}.
   *
   * @param budget the time that the search may take
   */
  public static Optional<Objection> objection(
      OclConstraint constraint, List<EObject> roots, TimeBudget budget) {
    ConstraintProof proof = new ConstraintProof(constraint, budget);
    ModelCopy model = ModelCopy.of(roots);
    proof.search(model);
    if (proof.holds && proof.fails) {
      return Optional.empty();
    }
    String within = proof.budget.isSpent() ? " in the time available" : "";
    String missing = proof.holds ? "fails" : "holds";
    return Optional.of(
        new Objection(
            proof.holds,
            proof.holds && constraint.isConditional(),
            proof.holds ? unknown(constraint, model) : List.of(),
            "No model was found%s for which '%s' %s"
                .formatted(within, constraint.name(), missing)));
  }

  private static List<String> unknown(OclConstraint constraint, ModelCopy model) {
    List<EAttribute> texts =
        constraint.navigations().stream()
            .map(Navigation::feature)
            .filter(EAttribute.class::isInstance)
            .map(EAttribute.class::cast)
            .filter(each -> each.getEAttributeType().getInstanceClass() == String.class)
            .toList();
    return texts.isEmpty() ? List.of() : new TriedValues(constraint, model).unknown(texts);
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
        break;
      }
      ModelCopy changed = model.with(first);
      tryAll(changed, ModelChange.all(changed, constraint));
    }
    if (!isFound() && constraint.context() instanceof EClass type) {
      tryRandom(new RandomModels(model, constraint, type));
    }
  }

  private void tryRandom(RandomModels changed) {
    for (int i = 0; i < MOST_RANDOM && changed.areThere() && !isFound(); i++) {
      judge(changed.next());
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
    return isFound() || models >= MOST_MODELS;
  }

  /** Returns whether both models have been found, or the time is over. */
  private boolean isFound() {
    return (holds && fails) || budget.isSpent();
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
