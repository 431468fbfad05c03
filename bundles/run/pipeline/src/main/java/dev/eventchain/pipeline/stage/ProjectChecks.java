package dev.eventchain.pipeline.stage;

import dev.eventchain.check.ChainChecks;
import dev.eventchain.check.Constraints;
import dev.eventchain.constraints.OclResult;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.pipeline.results.Validation;
import dev.eventchain.project.Requirements;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/** Checks of a run's project, based on the run's snapshots. */
public final class ProjectChecks {

  private ProjectChecks() {}

  /** Returns all constraints. */
  public static Constraints constraints(RunContext run) {
    Path output = run.options().output();
    return run.snapshots()
        .of(
            "constraints",
            run.project().constraintFiles(output),
            () -> Constraints.of(run.project(), output, run.options().timeLimit()));
  }

  /** Returns the checks of a project, with the vehicle and the messages of its software base. */
  static ChainChecks of(RunContext run) {
    Constraints constraints = constraints(run);
    List<WrittenRequirement> rules = run.designRules().map(Requirements::items).orElse(List.of());
    Path output = run.options().output();
    return of(run, constraints, ChainChecks.unchecked(run.project(), constraints, rules, output));
  }

  /** Returns the checks of a project before constraints are generated. */
  public static ChainChecks withoutGenerated(RunContext run) {
    Constraints written = Constraints.withoutGenerated(run.project(), run.options().timeLimit());
    return of(run, written, List.of());
  }

  private static ChainChecks of(
      RunContext run, Constraints constraints, List<Diagnostic> unchecked) {
    return ChainChecks.of(
        constraints, run.softwareBase(), run.messages(), run.writtenRequirements(), unchecked);
  }

  /** Returns the files that the checks of a project depend on, besides the chain's. */
  static List<Path> files(RunContext run) {
    List<Path> files = new ArrayList<>(run.project().constraintFiles(run.options().output()));
    files.add(run.project().designRulesFile());
    files.addAll(run.project().requirementFiles());
    files.addAll(run.project().softwareBaseFiles());
    files.addAll(run.project().messageFiles());
    return files;
  }

  /**
   * Throws unless the model is valid.
   *
   * @throws DiagnosticException FINDINGS if a finding is an error that is not suppressed
   */
  public static void refuseErrors(RunContext run, ChainChecks.Outcome outcome) {
    List<Diagnostic> found = run.options().suppressions().part(outcome.diagnostics()).remaining();
    if (Diagnostic.anyError(found)) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, found);
    }
  }

  /** Returns the results of the constraints, for the report. */
  public static Validation report(String model, OclResult result) {
    Set<String> violated = new TreeSet<>();
    result.diagnostics().stream().map(Diagnostic::rule).forEach(violated::add);
    return new Validation(
        model,
        result.constraints(),
        result.elements(),
        result.evaluations(),
        result.diagnostics().size(),
        List.copyOf(violated),
        result.checks().stream()
            .filter(check -> check.evaluations() > 0)
            .map(check -> check.constraint().qualifiedName())
            .toList());
  }
}
