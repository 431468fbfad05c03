package dev.eventchain.pipeline.design;

import dev.eventchain.agents.AgentResult;
import dev.eventchain.agents.ConstrainAgent;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.ChainSnapshot;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageResult;
import dev.eventchain.pipeline.stage.StageWork;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.Requirements;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Translates design rules to {@code generated.ocl}, if the project has any. They concern the chain
 * of its description, which needs no language model, or the edited chain.
 */
public final class ConstrainStage implements StageWork {

  @Override
  public void fingerprint(RunContext run, Fingerprint fingerprint) {
    AgentReport.fingerprint(run, Stage.CONSTRAIN, fingerprint);
    fingerprint.addFile(run.project().designRulesFile());
    Optional<Path> edited = run.project().editedModel();
    edited.ifPresent(fingerprint::addFile);
    if (edited.isEmpty()) {
      fingerprint.addFile(run.file(ProjectFolder.DESCRIPTION)).addRequirements();
    }
  }

  @Override
  public StageResult execute(RunContext run) {
    Optional<Requirements> rules = run.designRules();
    if (rules.isEmpty()) {
      List<String> none = List.of();
      return StageResult.of(
          "no design rules", none, run.output().removeOthers(ProjectFolder.GENERATED, none));
    }
    AgentResult constrained =
        new ConstrainAgent(run.models().agent(Stage.CONSTRAIN))
            .constrain(
                EventChainMetamodel.documented(),
                List.of(EventchainPackage.eINSTANCE),
                rules.get(),
                List.of(chain(run)));
    run.write(ProjectFolder.GENERATED, constrained.text());
    return new StageResult(
        "OCL from "
            + rules.get().items().size()
            + " design rules"
            + AgentReport.effort(run, List.of(constrained)),
        List.of(ProjectFolder.GENERATED),
        AgentReport.placed(run, constrained),
        AgentReport.of(run, Stage.CONSTRAIN, List.of(constrained)));
  }

  private static EventChain chain(RunContext run) {
    Optional<Path> edited = run.project().editedModel();
    if (edited.isPresent()) {
      return run.loadChain(edited.get()).chain();
    }
    Modeled<EventChain> direct =
        ChainSnapshot.direct(run, run.required(ProjectFolder.DESCRIPTION, Stage.DESIGN));
    if (Diagnostic.anyError(direct.diagnostics())) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, direct.diagnostics());
    }
    return direct.root();
  }
}
