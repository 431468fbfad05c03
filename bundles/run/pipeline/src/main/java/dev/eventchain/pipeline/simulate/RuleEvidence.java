package dev.eventchain.pipeline.simulate;

import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.constraints.OclResult;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.ocl.evaluation.TimeBudget;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.Requirements;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * Evidence from the constraints that implement a requirement or a design rule according to their
 * comments, on the measured model. A constraint that was never evaluated, or that holds for all
 * measured values, is not tested.
 */
final class RuleEvidence {

  private final List<Diagnostic> findings;
  private final Set<String> untestedConstraints = new TreeSet<>();
  private final Set<String> untestedIds = new TreeSet<>();
  private final Set<String> violatedIds = new TreeSet<>();

  private RuleEvidence(List<Diagnostic> findings) {
    this.findings = new ArrayList<>(findings);
  }

  /**
   * Returns the evidence for a project's requirements and design rules.
   *
   * @param measured the model that was validated
   * @param validation its result
   */
  static RuleEvidence of(RunContext run, EventChain measured, OclResult validation) {
    Set<String> ids = ids(run);
    Set<String> violated = new TreeSet<>();
    validation.diagnostics().stream().map(Diagnostic::rule).forEach(violated::add);
    RuleEvidence evidence = new RuleEvidence(validation.diagnostics());
    MeasuredValues values = new MeasuredValues(measured);
    for (OclResult.Check check : validation.checks()) {
      OclConstraint constraint = check.constraint();
      Set<String> named = new TreeSet<>(constraint.named(ids));
      if (violated.contains(constraint.qualifiedName()) || isExceeded(constraint, violated)) {
        evidence.violatedIds.addAll(named);
      } else if (!named.isEmpty() && !run.options().isPartial()) {
        TimeBudget budget = TimeBudget.of(run.options().timeLimit());
        why(check, values, budget).ifPresent(why -> evidence.miss(constraint, named, why));
      }
    }
    MissingTimes missing = MissingTimes.of(run, run.chain().chain(), validation);
    evidence.untestedIds.addAll(missing.ids());
    evidence.findings.addAll(missing.findings(run.chain()::locate));
    return evidence;
  }

  /** Returns whether a constraint states a bound of latencies, one of which was exceeded. */
  private static boolean isExceeded(OclConstraint constraint, Set<String> violated) {
    return constraint.context() == EventchainPackage.eINSTANCE.getLatencyConstraint()
        && violated.contains("LatencyConstraint::MeasuredLatencyWithinMaximum");
  }

  /** Returns the identifiers of requirements and design rules, of which nothing else matters. */
  static Set<String> ids(RunContext run) {
    Set<String> ids = new TreeSet<>();
    run.writtenRequirements().forEach(item -> ids.add(item.id()));
    FileReads.unrecorded(run::designRules).map(Requirements::items).orElse(List.of()).stream()
        .map(WrittenRequirement::id)
        .forEach(ids::add);
    return ids;
  }

  /** Returns the reason why a constraint without violations is not tested; empty if it is. */
  private static Optional<String> why(
      OclResult.Check check, MeasuredValues values, TimeBudget budget) {
    OclConstraint constraint = check.constraint();
    if (check.evaluations() == 0) {
      String context = constraint.context().getName();
      return Optional.of("the measured model has no " + context);
    }
    return values.decide(constraint, budget)
        ? Optional.empty()
        : Optional.of("it reads measured values, but holds no matter what was measured");
  }

  private void miss(OclConstraint constraint, Set<String> named, String why) {
    untestedConstraints.add(constraint.qualifiedName());
    untestedIds.addAll(named);
    String ids = String.join(" and ", named);
    findings.add(
        Diagnostic.of(
                SimulateRules.SIMULATION_RULE_UNTESTED,
                "'%s', which implements %s, was not tested: %s."
                    .formatted(constraint.qualifiedName(), ids, why),
                constraint.location())
            .withRule(constraint.qualifiedName())
            .withHint(
                "Let it constrain what the scenarios measure, add what it constrains to the model"
                    + " or the scenarios, or suppress this finding with a reason and an expiry"
                    + " date."));
  }

  /**
   * Returns the findings of the validation and, in a run of all scenarios, one for each untested
   * constraint.
   */
  List<Diagnostic> findings() {
    return findings;
  }

  /** Returns the qualified names of untested constraints, in order. */
  List<String> untestedConstraints() {
    return List.copyOf(untestedConstraints);
  }

  /** Returns the requirements and design rules of an untested constraint. */
  Set<String> untestedIds() {
    return untestedIds;
  }

  /** Returns the requirements and design rules of a violated constraint. */
  Set<String> violatedIds() {
    return violatedIds;
  }
}
