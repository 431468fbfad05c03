package dev.eventchain.contracts;

import dev.eventchain.contracts.latency.ChainTiming;
import dev.eventchain.contracts.latency.LatencyEstimate;
import dev.eventchain.contracts.latency.Stimuli;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.LatencyConstraint;

/**
 * Latency constraints against the bounds that follow from periods and worst cases. Only what cannot
 * be avoided is an error: phases are not part of a model, and a bound holds for the worst ones.
 * What passes before a message arrives is known to a simulation only.
 */
final class LatencyContracts {

  private static final double MILLISECOND = 1e6;

  private final EventChain chain;
  private final Findings findings;

  LatencyContracts(EventChain chain, Findings findings) {
    this.chain = chain;
    this.findings = findings;
  }

  void check() {
    ChainTiming timing = ChainTiming.of(chain, Stimuli.FRESH);
    for (LatencyConstraint constraint : chain.getLatencyConstraints()) {
      // Other rules report constraints that lack an end or a maximum, or connect nothing.
      if (constraint.getFirst() != null
          && constraint.getLast() != null
          && constraint.getMaximum() > 0) {
        LatencyEstimate estimate = timing.of(constraint);
        boolean connected = !estimate.paths().isEmpty() || !estimate.unknown().isEmpty();
        if (connected) {
          check(constraint, estimate);
        }
      }
    }
  }

  private void check(LatencyConstraint constraint, LatencyEstimate estimate) {
    findings.checked(ContractRule.LATENCY_BOUND);
    findings.checked(ContractRule.LATENCY_UNKNOWN);
    double maximum = constraint.getMaximum() * MILLISECOND;
    if (estimate.unavoidable() > maximum) {
      unavoidable(constraint, estimate);
    } else if (estimate.known() > maximum && estimate.bound().isEmpty()) {
      incomplete(constraint, estimate);
    } else if (estimate.bound().orElse(0) > maximum) {
      possible(constraint, estimate);
    }
    if (!estimate.unknown().isEmpty()) {
      findings.info(
          ContractRule.LATENCY_UNKNOWN,
          at(constraint),
          "No bound on the time of '%s' is known: %s."
              .formatted(constraint.getName(), String.join("; ", estimate.unknown())),
          "State it where the model has a place for it. What a simulation measures is one case; a bound covers all.");
    }
  }

  private void unavoidable(LatencyConstraint constraint, LatencyEstimate estimate) {
    findings.error(
        ContractRule.LATENCY_BOUND,
        at(constraint),
        "%s, but the worst cases alone are %s ms."
            .formatted(allowed(constraint), LatencyEstimate.milliseconds(estimate.unavoidable())),
        "No phases help: make components on the way faster, or allow more time.");
  }

  private void incomplete(LatencyConstraint constraint, LatencyEstimate estimate) {
    findings.warning(
        ContractRule.LATENCY_BOUND,
        at(constraint),
        "%s, but %s ms are possible by the times that are known alone."
            .formatted(allowed(constraint), LatencyEstimate.milliseconds(estimate.known())),
        "Execute components on the way more often or faster, or allow more time.");
  }

  private void possible(LatencyConstraint constraint, LatencyEstimate estimate) {
    findings.warning(
        ContractRule.LATENCY_BOUND,
        at(constraint),
        "%s, but up to %s ms are possible (waiting + execution: %s)."
            .formatted(
                allowed(constraint),
                LatencyEstimate.milliseconds(estimate.bound().orElseThrow()),
                estimate.shares()),
        "Execute components on the way more often or faster, or allow more time. The bound: "
            + estimate.assumption(estimate.slowest().orElseThrow())
            + ".");
  }

  private static String allowed(LatencyConstraint constraint) {
    return "'%s' allows %s ms from '%s' to '%s'"
        .formatted(
            constraint.getName(),
            LatencyEstimate.milliseconds(Math.round(constraint.getMaximum() * MILLISECOND)),
            constraint.getFirst().getName(),
            constraint.getLast().getName());
  }

  private SourceLocation at(LatencyConstraint constraint) {
    return findings.at(constraint, Literals.LATENCY_CONSTRAINT__MAXIMUM);
  }
}
