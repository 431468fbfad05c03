package dev.eventchain.pipeline.design;

import dev.eventchain.agents.AgentResult;
import dev.eventchain.agents.ModelAgent;
import dev.eventchain.check.ChainModel;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.pipeline.project.Configuration;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.ChainSnapshot;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageResult;
import dev.eventchain.pipeline.stage.StageWork;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.xmi.XmiStore;
import java.nio.file.Path;
import java.util.List;

/**
 * Writes the event chain as an instance of the metamodel, {@code chain.xmi}: by a language model,
 * whose answer is compared with the model converted directly from the description; or only
 * directly, with the setting {@code model: direct}.
 */
public final class ModelStage implements StageWork {

  @Override
  public void fingerprint(RunContext run, Fingerprint fingerprint) {
    AgentReport.fingerprint(run, Stage.MODEL, fingerprint);
    fingerprint
        .addFile(run.file(ProjectFolder.DESCRIPTION))
        .addRequirements()
        .addFile(run.project().componentsFile());
    run.project().editedModel().ifPresent(fingerprint::addFile);
  }

  @Override
  public StageResult execute(RunContext run) {
    if (run.project().editedModel().isPresent()) {
      return StageResult.of("model/chain.xmi, which people edit", List.of(), List.of());
    }
    Path description = run.required(ProjectFolder.DESCRIPTION, Stage.DESIGN);
    Modeled<EventChain> direct = ChainSnapshot.direct(run, description);
    refuseErrors(direct.diagnostics());
    if (run.project()
        .configuration()
        .models(Stage.MODEL.id())
        .equals(List.of(Configuration.DIRECT))) {
      run.write(ProjectFolder.MODEL, XmiStore.toBytes(direct.root()));
      return StageResult.of(
          words(direct.root()) + ", directly", List.of(ProjectFolder.MODEL), direct.diagnostics());
    }
    return modelByAgent(run, SourceText.read(description), direct.root());
  }

  private static StageResult modelByAgent(
      RunContext run, SourceText description, EventChain direct) {
    ModelAgent.Answer answer =
        new ModelAgent(run.models().agent(Stage.MODEL))
            .model(
                EventChainMetamodel.documented(),
                description,
                run.project().configuration().name(),
                run.requirements(),
                run.softwareBase());
    AgentResult answered = answer.result();
    refuseErrors(answer.model().diagnostics());
    EventChain chain = (EventChain) answer.model().root();
    run.softwareBase().addUnasked(chain, direct);
    ChainModel.complete(chain, run.project().configuration().settings(), run.softwareBase());
    run.write(ProjectFolder.MODEL, XmiStore.toBytes(chain));
    return new StageResult(
        words(chain)
            + ", language model and direct conversion agree"
            + AgentReport.effort(run, List.of(answered)),
        List.of(ProjectFolder.MODEL),
        answered.diagnostics(),
        AgentReport.of(run, Stage.MODEL, List.of(answered)));
  }

  private static void refuseErrors(List<Diagnostic> diagnostics) {
    if (Diagnostic.anyError(diagnostics)) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, diagnostics);
    }
  }

  private static String words(EventChain chain) {
    return chain.getSoftware().size() + " nodes, " + chain.getData().size() + " data";
  }
}
