package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.scenario.NumberFormulas.Condition;
import dev.eventchain.simulation.scenario.NumberFormulas.Quantity;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;

/**
 * Points of a protocol for cases.
 *
 * @param source the protocol, with its version
 * @param most the points of a case that passed without an impact
 * @param share the part of them for an impact, from 0 to 1; empty if there are none
 * @param criteria beginnings of the texts of the criteria on which points depend besides impacts;
 *     those of a case that has none of them depend on all, as long as there is no impact
 * @param counted true of the cases that the protocol has
 */
public record Points(
    String source,
    Quantity most,
    Optional<Quantity> share,
    List<String> criteria,
    List<Condition> counted,
    SourceLocation place) {

  /** The name of the relative impact speed in formulas, in km/h. */
  static final String IMPACT = "impact";

  /** Faster than any impact, in km/h. */
  private static final double FASTEST = 500.0;

  private static final double KMH = 3.6;

  /**
   * Points of a case.
   *
   * @param points empty if the case, or a criterion on which they depend, was not tested; if it
   *     ended by an error; and if it is none of the protocol
   * @param most for a case that passes without an impact; 0 if it is none of the protocol
   * @param isCounted whether the protocol has such a case
   */
  public record Score(OptionalDouble points, double most, boolean isCounted) {}

  /** Copies the lists. */
  public Points {
    criteria = List.copyOf(criteria);
    counted = List.copyOf(counted);
  }

  /** Returns the names that the formulas read, without that of the impact speed. */
  Set<String> names() {
    Set<String> names = new TreeSet<>(most.names());
    share.ifPresent(it -> names.addAll(it.names()));
    counted.forEach(it -> names.addAll(it.names()));
    names.remove(IMPACT);
    return names;
  }

  /**
   * Requires of the formulas that a case has points, however fast an impact is.
   *
   * @param numbers the factors of a case, and what is computed from them
   * @throws DiagnosticException (INPUT) if it has none
   */
  void require(Map<String, Double> numbers) {
    if (!isCounted(numbers)) {
      return;
    }
    most(numbers);
    share(numbers, 0.0);
    share(numbers, FASTEST);
  }

  /** Returns the points of a case. */
  public Score of(Map<String, Double> numbers, CaseResult result) {
    if (!isCounted(numbers)) {
      return new Score(OptionalDouble.empty(), 0.0, false);
    }
    double whole = most(numbers);
    if (result.label() == Label.ERROR || result.label() == Label.UNTESTED) {
      return new Score(OptionalDouble.empty(), whole, true);
    }
    OptionalDouble impact = result.impactSpeed();
    double part = impact.isPresent() ? share(numbers, impact.getAsDouble() * KMH) : 1.0;
    return new Score(kept(result, part * whole), whole, true);
  }

  /**
   * Returns the points that the criteria leave of those for an impact or for none: 0 if one of
   * those on which they depend failed, and empty if none did and one was not tested. Those of a
   * case that has none of these depend on all that it has.
   */
  private OptionalDouble kept(CaseResult result, double points) {
    List<Label> labels =
        result.criteria().stream()
            .filter(each -> criteria.stream().anyMatch(each.name()::startsWith))
            .map(CriterionMargin::label)
            .toList();
    if (labels.isEmpty()) {
      boolean isKept = result.label() == Label.PASSED || result.impactSpeed().isPresent();
      return OptionalDouble.of(isKept ? points : 0.0);
    }
    if (labels.contains(Label.FAILED) || points == 0.0) {
      return OptionalDouble.of(0.0);
    }
    return labels.contains(Label.UNTESTED) ? OptionalDouble.empty() : OptionalDouble.of(points);
  }

  boolean isCounted(Map<String, Double> numbers) {
    return counted.stream().allMatch(each -> each.holds().test(numbers));
  }

  private double most(Map<String, Double> numbers) {
    double value = most.value().applyAsDouble(numbers);
    if (value >= 0.0 && Double.isFinite(value)) {
      return value;
    }
    throw wrong("'most' is no number from 0 on: " + value);
  }

  private double share(Map<String, Double> numbers, double impact) {
    Map<String, Double> all = new HashMap<>(numbers);
    all.put(IMPACT, impact);
    double value = share.map(it -> it.value().applyAsDouble(all)).orElse(0.0);
    if (value >= 0.0 && value <= 1.0) {
      return value;
    }
    throw wrong("'at_impact' is not from 0 to 1 at %s km/h: %s".formatted(impact, value));
  }

  private DiagnosticException wrong(String message) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(CampaignRules.FORMULA, message + ".", place));
  }
}
