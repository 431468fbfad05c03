package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.scenario.NumberFormulas.Quantity;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.util.HashMap;
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
 */
public record Points(String source, Quantity most, Optional<Quantity> share, SourceLocation place) {

  /** The name of the relative impact speed in formulas, in km/h. */
  static final String IMPACT = "impact";

  /** Faster than any impact, in km/h. */
  private static final double FASTEST = 500.0;

  private static final double KMH = 3.6;

  /**
   * Points of a case.
   *
   * @param points empty if the case was not tested, or ended by an error
   * @param most for a case that passes without an impact
   */
  public record Score(OptionalDouble points, double most) {}

  /** Returns the names that the formulas read, without that of the impact speed. */
  Set<String> names() {
    Set<String> names = new TreeSet<>(most.names());
    share.ifPresent(it -> names.addAll(it.names()));
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
    most(numbers);
    share(numbers, 0.0);
    share(numbers, FASTEST);
  }

  /** Returns the points of a case. */
  public Score of(Map<String, Double> numbers, CaseResult result) {
    double whole = most(numbers);
    if (result.label() == Label.ERROR || result.label() == Label.UNTESTED) {
      return new Score(OptionalDouble.empty(), whole);
    }
    double without = result.label() == Label.PASSED ? 1.0 : 0.0;
    double part =
        result.impactSpeed().isPresent()
            ? share(numbers, result.impactSpeed().getAsDouble() * KMH)
            : without;
    return new Score(OptionalDouble.of(part * whole), whole);
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
