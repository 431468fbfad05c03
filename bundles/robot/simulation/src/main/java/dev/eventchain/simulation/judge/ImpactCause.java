package dev.eventchain.simulation.judge;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Criterion;
import dev.eventchain.simulation.scenario.CriterionKind;
import dev.eventchain.simulation.scenario.Expectation;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/** Tells the finding about an impact from its consequences, so that one cause is told once. */
final class ImpactCause {

  /** Criteria that fail by an impact and say so, the plainest first. */
  private static final List<CriterionKind> ABOUT_IMPACTS =
      List.of(CriterionKind.NO_IMPACT, CriterionKind.MAXIMAL_IMPACT_SPEED, CriterionKind.STOPS);

  /** Criteria that no run with an impact meets, except for slow ones where they are allowed. */
  private static final Set<CriterionKind> FAILED_BY_IMPACTS = EnumSet.copyOf(ABOUT_IMPACTS);

  static {
    FAILED_BY_IMPACTS.add(CriterionKind.MINIMAL_GAP);
  }

  private ImpactCause() {}

  /**
   * Returns the finding about an impact that the outcome of a criterion is a consequence of. What
   * failed before the impact is none, since it may be its reason.
   *
   * @param fails whether another criterion of the run fails
   */
  static Optional<Diagnostic.Cause> of(
      Expectation criterion, Outcome outcome, ScenarioRun run, Predicate<Expectation> fails) {
    boolean follows = outcome.undecided() || (outcome.failed() && isFailedByImpacts(criterion));
    if (!follows || run.trace().impactSpeed().isEmpty()) {
      return Optional.empty();
    }
    return finding(run, fails)
        .filter(place -> !place.equals(criterion.location()))
        .map(place -> new Diagnostic.Cause(place, name(criterion)));
  }

  private static boolean isFailedByImpacts(Expectation criterion) {
    return criterion instanceof Criterion known && FAILED_BY_IMPACTS.contains(known.kind());
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

  private static String name(Expectation criterion) {
    return criterion.requirements().isEmpty()
        ? criterion.title()
        : criterion.title() + " (" + String.join(", ", criterion.requirements()) + ")";
  }
}
