package dev.eventchain.simulation.judge;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Criterion;
import dev.eventchain.simulation.scenario.CriterionKind;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.world.World;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;

/** Tells the finding about an impact from its consequences, so that one cause is told once. */
final class ImpactCause {

  /** Criteria that fail by an impact and say so, the plainest first. */
  private static final List<CriterionKind> ABOUT_IMPACTS =
      List.of(CriterionKind.NO_IMPACT, CriterionKind.MAXIMAL_IMPACT_SPEED, CriterionKind.STOPS);

  /** A gap that is taken for contact, in m. */
  private static final double CONTACT = 0.05;

  private ImpactCause() {}

  /**
   * Returns the finding about an impact that the outcome of a criterion is a consequence of. What
   * failed before the impact is none, since it may be its reason.
   *
   * @param fails whether another criterion of the run fails
   */
  static Optional<Diagnostic.Cause> of(
      Expectation criterion, Outcome outcome, ScenarioRun run, Predicate<Expectation> fails) {
    boolean follows =
        outcome.undecided() || (outcome.failed() && isFailedByImpact(criterion, outcome, run));
    if (!follows || run.trace().impactSpeed().isEmpty()) {
      return Optional.empty();
    }
    return finding(run, fails)
        .filter(place -> !place.equals(criterion.location()))
        .map(place -> new Diagnostic.Cause(place, name(criterion)));
  }

  /** Returns whether the impact itself fails a criterion: no gap that was too small before it. */
  private static boolean isFailedByImpact(Expectation criterion, Outcome outcome, ScenarioRun run) {
    return ABOUT_IMPACTS.stream().anyMatch(kind -> isOf(criterion, kind))
        || (isOf(criterion, CriterionKind.MINIMAL_GAP)
            && run.trace().end().gap() <= CONTACT
            && outcome.margin().stream()
                .allMatch(it -> it.time() >= World.seconds(run.trace().end().time())));
  }

  private static Optional<SourceLocation> finding(ScenarioRun run, Predicate<Expectation> fails) {
    if (!run.scenario().judgesImpact()) {
      return Optional.of(run.scenario().location()); // That no criterion is about it is a finding.
    }
    return ABOUT_IMPACTS.stream()
        .flatMap(kind -> run.scenario().criteria().stream().filter(each -> isOf(each, kind)))
        .filter(fails)
        .map(Expectation::location)
        .findFirst();
  }

  private static boolean isOf(Expectation criterion, CriterionKind kind) {
    return criterion instanceof Criterion known && known.kind() == kind;
  }

  static String name(Expectation criterion) {
    return criterion.requirements().isEmpty()
        ? criterion.title()
        : criterion.title() + " (" + String.join(", ", criterion.requirements()) + ")";
  }
}
