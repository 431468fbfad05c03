package dev.eventchain.pipeline.design;

import dev.eventchain.agents.AgentResult;
import dev.eventchain.agents.DesignAgent;
import dev.eventchain.check.ChainChecks;
import dev.eventchain.check.ChainModel;
import dev.eventchain.description.EventChainWriter;
import dev.eventchain.pipeline.project.Configuration;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.ProjectChecks;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageResult;
import dev.eventchain.pipeline.stage.StageWork;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Designs {@code chain.json} from requirements and software base. If people edit the chain's model,
 * the chain is written from that model.
 */
public final class DesignStage implements StageWork {

  @Override
  public void fingerprint(RunContext run, Fingerprint fingerprint) {
    Project project = run.project();
    AgentReport.fingerprint(run, Stage.DESIGN, fingerprint);
    fingerprint.addRequirements().addFile(project.designRulesFile());
    fingerprint.addFiles(project.softwareBaseFiles());
    fingerprint.addMessages();
    project.catalogue().ifPresent(it -> fingerprint.addSetting("catalogue", it.choice()));
    project.editedModel().ifPresent(fingerprint::addFile);
    fingerprint.addFiles(project.ownConstraints());
  }

  @Override
  public StageResult execute(RunContext run) {
    Optional<Path> edited = run.project().editedModel();
    return edited.isPresent() ? describe(run, edited.get()) : design(run);
  }

  private static StageResult describe(RunContext run, Path edited) {
    ChainModel model = run.loadChain(edited);
    ChainChecks.Outcome checked = ProjectChecks.withoutGenerated(run).check(model);
    ProjectChecks.refuseErrors(run, checked);
    run.write(ProjectFolder.DESCRIPTION, EventChainWriter.write(model.chain()));
    return StageResult.of(
        "the chain of model/chain.xmi, which people edit",
        List.of(ProjectFolder.DESCRIPTION),
        checked.diagnostics());
  }

  private static StageResult design(RunContext run) {
    Optional<OfferedSignals> offered = OfferedSignals.of(run);
    offered.ifPresent(signals -> signals.report(run));
    AgentResult designed =
        run.models()
            .correction()
            .design()
            .orElseGet(
                () ->
                    new DesignAgent(run.models().agent(Stage.DESIGN)).design(asked(run, offered)));
    run.write(ProjectFolder.DESCRIPTION, designed.text());
    int count = run.requirements().items().size();
    return new StageResult(
        "event chain from "
            + count
            + " requirements"
            + offered.map(OfferedSignals::words).orElse("")
            + AgentReport.effort(run, List.of(designed)),
        offered.isPresent()
            ? List.of(ProjectFolder.DESCRIPTION, OfferedSignals.FILE)
            : List.of(ProjectFolder.DESCRIPTION),
        AgentReport.placed(run, designed),
        AgentReport.of(run, Stage.DESIGN, List.of(designed)));
  }

  /** Returns what the design of a project is asked for. */
  static DesignAgent.Asked asked(RunContext run) {
    return asked(run, OfferedSignals.of(run));
  }

  private static DesignAgent.Asked asked(RunContext run, Optional<OfferedSignals> offered) {
    Configuration configuration = run.project().configuration();
    return new DesignAgent.Asked(
        configuration.title(),
        configuration.frequency(),
        run.requirements(),
        run.designRules(),
        offered.map(signals -> signals.in(run.softwareBase())).orElseGet(run::softwareBase),
        run.messages());
  }
}
