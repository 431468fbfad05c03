package dev.eventchain.simulation.variant;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.sandbox.ComponentRules;
import dev.eventchain.simulation.host.HostRules;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.run.ScenarioRunner;
import dev.eventchain.simulation.verdict.VariantReaction;
import java.util.List;
import java.util.Optional;

/**
 * A variant of a component in one scenario after the other, until one notices it. A process that
 * ends may have been ended by the machine, so that it is only evidence if it ends again.
 */
public final class VariantTrial {

  /** Failures of a node: by values of its component that it cannot send, or by its own code. */
  private static final List<Rule> OF_NODE =
      List.of(
          HostRules.NODE_FAILED,
          HostRules.NODE_TIMEOUT,
          HostRules.NODE_ENDPOINT_LATE,
          HostRules.MESSAGE_MALFORMED,
          HostRules.SIMULATION_LIMIT,
          HostRules.SIMULATION_STEP_TIMEOUT);

  /** Ends of a process, of which nobody says who caused them. */
  private static final List<Rule> ENDS =
      List.of(HostRules.SIMULATION_PROCESS_ENDED, ComponentRules.ENDED);

  private final List<PassedScenario> scenarios;
  private final Optional<Diagnostic> untold;

  /**
   * Creates a trial.
   *
   * @param scenarios the scenarios that tell something, in the order of the trial
   * @param untold the finding about another one, which tells nothing, since a process ends in it
   *     with the components as they are
   */
  public VariantTrial(List<PassedScenario> scenarios, Optional<Diagnostic> untold) {
    this.scenarios = scenarios;
    this.untold = untold;
  }

  /**
   * Drives the scenarios. If a process ends, the reaction has to be {@linkplain #repeat repeated}.
   *
   * @param runner runs them with the variant
   * @throws DiagnosticException if a run ends for another reason than what the component does
   */
  public VariantReaction run(ScenarioRunner runner) {
    boolean changed = false;
    PassedScenario.Judged nearest = PassedScenario.Judged.NONE;
    for (PassedScenario scenario : scenarios) {
      ScenarioRun run;
      try {
        run = runner.run(scenario.scenario());
      } catch (DiagnosticException e) {
        return raised(scenario, e);
      }
      PassedScenario.Judged judged = scenario.judge(run);
      if (judged.reaction().kind().isNoticed()) {
        return judged.reaction();
      }
      changed |= scenario.differs(run);
      if (judged.left() < nearest.left()) {
        nearest = judged;
      }
    }
    if (untold.isPresent()) {
      String words = untold.get().message();
      return new VariantReaction(VariantReaction.Kind.UNPROVED, "", words, Optional.empty());
    }
    return changed
        ? nearest.reaction()
        : new VariantReaction(VariantReaction.Kind.UNCHANGED, "", "", Optional.empty());
  }

  /**
   * Drives the scenario in which a process ended again, first with the components as they are.
   *
   * @param ended the reaction of the kind ENDED
   * @param original runs scenarios with the components as they are
   * @param variant runs them with the variant, in the same process
   * @return the same reaction, or one of the kind UNPROVED
   * @throws DiagnosticException if the run with the components as they are fails for another reason
   *     than that a process ends, which the machine may do to it, too
   */
  public VariantReaction repeat(
      VariantReaction ended, ScenarioRunner original, ScenarioRunner variant) {
    PassedScenario scenario =
        scenarios.stream()
            .filter(each -> each.scenario().name().equals(ended.scenario()))
            .findFirst()
            .orElseThrow();
    if (passes(scenario, original)) {
      try {
        variant.run(scenario.scenario());
      } catch (DiagnosticException e) {
        if (raised(scenario, e).equals(ended)) {
          return ended;
        }
      }
    }
    return scenario.reaction(VariantReaction.Kind.UNPROVED, ended.words(), Optional.empty());
  }

  private static boolean passes(PassedScenario scenario, ScenarioRunner original) {
    try {
      ScenarioRun run = original.run(scenario.scenario());
      return !scenario.judge(run).reaction().kind().isNoticed();
    } catch (DiagnosticException e) {
      if (isEnd(e)) {
        return false;
      }
      throw e;
    }
  }

  /** Returns whether a run ended since a process did, of which nobody says who caused it. */
  public static boolean isEnd(DiagnosticException end) {
    return ENDS.stream().anyMatch(end.diagnostics().get(0)::is);
  }

  private static VariantReaction raised(PassedScenario scenario, DiagnosticException end) {
    Diagnostic finding = end.diagnostics().get(0);
    if (isEnd(end)) {
      return scenario.reaction(VariantReaction.Kind.ENDED, finding.message(), Optional.empty());
    }
    boolean ofComponent =
        ComponentRules.find(finding.id()).isPresent() || OF_NODE.stream().anyMatch(finding::is);
    if (end.reason() != DiagnosticException.Reason.FINDINGS || !ofComponent) {
      throw end;
    }
    return scenario.reaction(VariantReaction.Kind.RAISED, finding.message(), Optional.empty());
  }
}
