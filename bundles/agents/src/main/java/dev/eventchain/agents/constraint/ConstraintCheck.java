package dev.eventchain.agents.constraint;

import dev.eventchain.constraints.ConstraintProof;
import dev.eventchain.constraints.ConstraintProof.Objection;
import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.constraints.OclRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.evaluation.DeepStack;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;

/** Checks that an OCL document parses, covers every design rule, and has no trivial constraint. */
public final class ConstraintCheck {

  private final List<String> ruleIds;
  private final Collection<EPackage> packages;
  private final List<EObject> model;

  /**
   * Creates a check.
   *
   * @param ruleIds the ids of the design rules
   * @param packages the metamodel
   * @param model the roots of a model to start the search for witnesses from; it stays unchanged
   */
  public ConstraintCheck(List<String> ruleIds, Collection<EPackage> packages, List<EObject> model) {
    this.ruleIds = List.copyOf(ruleIds);
    this.packages = packages;
    this.model = List.copyOf(model);
  }

  public List<Diagnostic> check(SourceText document) {
    OclRules rules = OclRules.parse(List.of(document), packages);
    List<Diagnostic> diagnostics = new ArrayList<>(rules.diagnostics());
    if (Diagnostic.anyError(diagnostics)) {
      return diagnostics;
    }
    if (rules.constraints().isEmpty()) {
      diagnostics.add(
          Diagnostic.of(
              OclAnswerRules.CONSTRAINT_NONE,
              "The document contains no invariant.",
              document.at(0)));
      return diagnostics;
    }
    diagnostics.addAll(uncovered(document, rules));
    diagnostics.addAll(vacuous(rules.constraints()));
    return diagnostics;
  }

  private List<Diagnostic> uncovered(SourceText document, OclRules rules) {
    Set<String> covered =
        rules.constraints().stream()
            .flatMap(constraint -> constraint.named(ruleIds).stream())
            .collect(Collectors.toSet());
    return ruleIds.stream()
        .filter(id -> !covered.contains(id))
        .map(
            id ->
                Diagnostic.of(
                        OclAnswerRules.RULE_UNCOVERED,
                        "No constraint is marked as the one for the design rule " + id + ".",
                        document.at(0))
                    .withHint("Write '-- " + id + ": ...' right above its invariant."))
        .toList();
  }

  private List<Diagnostic> vacuous(List<OclConstraint> constraints) {
    return DeepStack.call(
        () -> constraints.stream().flatMap(each -> objection(each).stream()).toList());
  }

  private Optional<Diagnostic> objection(OclConstraint constraint) {
    return ConstraintProof.objection(constraint, model)
        .map(
            objection ->
                Diagnostic.of(
                        OclAnswerRules.CONSTRAINT_VACUOUS,
                        objection.message() + because(objection),
                        constraint.location())
                    // A search shows that a constraint can fail, never that it cannot.
                    .withSeverity(severity(constraint, objection))
                    .withHint("Write it so that it can both hold and fail.")
                    .withRule(constraint.qualifiedName()));
  }

  private static String because(Objection objection) {
    return objection.unknown().isEmpty()
        ? ": changed values, references and contained objects of the model made no difference."
        : ": nothing in the model is '" + String.join("' or '", objection.unknown()) + "'.";
  }

  private static Severity severity(OclConstraint constraint, Objection objection) {
    boolean possible = objection.doubtful() && objection.unknown().isEmpty();
    return possible && !constraint.holdsForAnything() ? Severity.WARNING : Severity.ERROR;
  }
}
