package dev.eventchain.pipeline.generate;

import dev.eventchain.check.ChainChecks;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.pipeline.project.Templates;
import dev.eventchain.pipeline.results.Validated;
import dev.eventchain.pipeline.results.Validation;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.ComponentSources;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.ProjectChecks;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.SimulationInputs;
import dev.eventchain.pipeline.stage.StageResult;
import dev.eventchain.pipeline.stage.StageWork;
import java.util.ArrayList;
import java.util.List;

/**
 * Checks the model against its constraints and contracts, and the source of existing components; as
 * the last stage, also everything else that the later stages of a run would refuse before they
 * simulate.
 */
public final class ValidateStage implements StageWork {

  @Override
  public void fingerprint(RunContext run, Fingerprint fingerprint) {
    // Always runs, for up-to-date findings.
  }

  @Override
  public boolean skippable() {
    return false;
  }

  @Override
  public StageResult execute(RunContext run) {
    ChainChecks.Outcome outcome = checked(run);
    Validation validation =
        ProjectChecks.report(SourceLocation.of(run.model()).file(), outcome.constraints());
    List<String> files = new ArrayList<>();
    files.add(SourceLocation.of(run.model()).file());
    files.addAll(run.project().constraintNames(run.options().output()));
    return new StageResult(
        outcome.words(),
        List.of(),
        findings(run, outcome),
        new Validated(validation),
        outcome.coverage(files));
  }

  /** Checks the chain; if it cannot be read, the other inputs are checked all the same. */
  private static ChainChecks.Outcome checked(RunContext run) {
    try {
      return run.chain().checks();
    } catch (DiagnosticException e) {
      List<Diagnostic> all = new ArrayList<>(e.diagnostics());
      if (run.options().stages().last() == Stage.VALIDATE) {
        all.addAll(sources(run, false));
      }
      all.addAll(otherInputs(run, false));
      throw new DiagnosticException(e.reason(), all.stream().distinct().toList());
    }
  }

  private static List<Diagnostic> findings(RunContext run, ChainChecks.Outcome outcome) {
    List<Diagnostic> found = new ArrayList<>(outcome.diagnostics());
    List<String> named =
        run.chain().chain().getRequirements().stream().map(Requirement::getId).toList();
    run.project().missingRequirements(named).ifPresent(found::add);
    boolean valid = !run.anyErrorCounts(outcome.diagnostics());
    found.addAll(sources(run, valid));
    found.addAll(otherInputs(run, valid));
    return found.stream().distinct().toList();
  }

  /** Returns the findings in the source of existing components. */
  private static List<Diagnostic> sources(RunContext run, boolean valid) {
    ComponentSources read;
    try {
      read = valid ? ComponentSources.of(run) : ComponentSources.withoutChain(run);
    } catch (DiagnosticException e) {
      if (run.options().stages().last() == Stage.VALIDATE
          && e.reason() == DiagnosticException.Reason.INPUT) {
        return e.diagnostics(); // The other inputs are checked all the same.
      }
      throw e;
    }
    return read.check(Stage.VALIDATE);
  }

  /** Returns the findings in inputs of later stages; none if these run themselves. */
  private static List<Diagnostic> otherInputs(RunContext run, boolean valid) {
    if (run.options().stages().last() != Stage.VALIDATE) {
      return List.of();
    }
    List<Diagnostic> found = new ArrayList<>(SimulationInputs.all(run, valid));
    if (Templates.own(run.project()).isPresent()) {
      found.addAll(ownTemplate(run));
    }
    return found;
  }

  private static List<Diagnostic> ownTemplate(RunContext run) {
    try {
      return Templates.compile(
              run.project(), List.of(EventchainPackage.eINSTANCE, MessageModel.metamodel()))
          .warnings();
    } catch (DiagnosticException e) {
      return e.diagnostics();
    }
  }
}
