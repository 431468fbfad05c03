package dev.eventchain.simulation.variant;

import dev.eventchain.simulation.judge.ScenarioJudge;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import dev.eventchain.simulation.verdict.VariantReaction;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** A scenario with the components as they are, and what its criteria say there. */
public final class PassedScenario {

  /** Those with many criteria first, which notice most; of these, the shortest. */
  public static final Comparator<PassedScenario> ORDER =
      Comparator.comparing((PassedScenario each) -> each.results.size(), Comparator.reverseOrder())
          .thenComparing(each -> each.run.scenario().duration())
          .thenComparing(each -> each.run.scenario().name());

  private final ScenarioRun run;
  private final ScenarioJudge judge;
  private final List<CriterionResult> results;

  /**
   * Creates a scenario.
   *
   * @param run its run with the components as they are
   * @param judge a judge that knows such runs of all scenarios
   */
  public PassedScenario(ScenarioRun run, ScenarioJudge judge) {
    this.run = run;
    this.judge = judge;
    this.results = judge.criteria(run, true);
  }

  Scenario scenario() {
    return run.scenario();
  }

  /** Returns whether a variant changed what components write. */
  boolean differs(ScenarioRun variant) {
    return variant.outputs().digest() != run.outputs().digest();
  }

  /**
   * The reaction of a scenario.
   *
   * @param left the part of the nearest criterion's margin that is left; infinite if none has a
   *     size
   */
  record Judged(VariantReaction reaction, double left) {

    /** Nothing noticed the variant or came near. */
    static final Judged NONE =
        new Judged(
            new VariantReaction(VariantReaction.Kind.UNNOTICED, "", "", Optional.empty()), 1);
  }

  /** Judges a variant; a failed criterion counts before one that could not be judged. */
  Judged judge(ScenarioRun variant) {
    List<CriterionResult> now = judge.criteria(variant, true);
    Optional<VariantReaction> untested = Optional.empty();
    Judged nearest = Judged.NONE;
    for (int i = 0; i < now.size(); i++) {
      CriterionResult result = now.get(i);
      if (results.get(i).passed() && result.tested() && !result.passed()) {
        return new Judged(
            reaction(VariantReaction.Kind.CRITERION, result.text(), result.margin()), 0);
      }
      if (results.get(i).passed() && !result.passed() && !isUnasked(result, variant)) {
        untested = untested.or(() -> Optional.of(untested(result.text())));
      }
      double left = result.leftOf(results.get(i));
      // Criteria without a requirement are those of every scenario, which nobody can tighten.
      if (left < nearest.left() && !result.requirements().isEmpty()) {
        VariantReaction.Kind kind = VariantReaction.Kind.UNNOTICED;
        nearest = new Judged(reaction(kind, result.text(), result.margin()), left);
      }
    }
    if (hasImpact(variant) && !hasImpact(run)) {
      untested = untested.or(() -> Optional.of(untested("an impact that no criterion is about")));
    }
    return untested.isPresent() ? new Judged(untested.get(), 0) : nearest;
  }

  private boolean isUnasked(CriterionResult result, ScenarioRun variant) {
    return variant.scenario().criteria().stream()
        .filter(each -> each.location().equals(result.location()))
        .anyMatch(each -> judge.isUnasked(each, variant));
  }

  private static boolean hasImpact(ScenarioRun run) {
    return run.trace().impactSpeed().isPresent() && !run.scenario().judgesImpact();
  }

  private VariantReaction untested(String words) {
    return reaction(VariantReaction.Kind.UNTESTED, words, Optional.empty());
  }

  VariantReaction reaction(VariantReaction.Kind kind, String words, Optional<Margin> margin) {
    return new VariantReaction(kind, scenario().name(), words, margin);
  }
}
