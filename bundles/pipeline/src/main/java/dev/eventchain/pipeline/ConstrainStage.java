package dev.eventchain.pipeline;

import dev.eventchain.agents.AgentResult;
import dev.eventchain.agents.ConstrainAgent;
import dev.eventchain.metamodel.XmiStore;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import dev.eventchain.modeler.Requirements;
import java.util.List;
import java.util.Optional;

/** Design rules to {@code generated.ocl}. A project without design rules has none. */
final class ConstrainStage implements StageWork {

  @Override
  public void fingerprint(RunContext run, Fingerprint fingerprint) {
    AgentReport.fingerprint(run, Stage.CONSTRAIN, fingerprint);
    fingerprint.addFile(run.project().designRulesFile()).addFile(run.model());
  }

  @Override
  public StageResult execute(RunContext run) {
    Optional<Requirements> rules = run.designRules();
    if (rules.isEmpty()) {
      List<String> none = List.of();
      return StageResult.of(
          "no design rules", none, run.output().removeOthers(Constraints.GENERATED, none));
    }
    AgentResult constrained =
        new ConstrainAgent(run.agent(Stage.CONSTRAIN))
            .constrain(
                XmiStore.eventchainEcore(),
                List.of(EventchainPackage.eINSTANCE),
                rules.get(),
                List.of(run.chain().chain()));
    run.write(Constraints.GENERATED, constrained.text());
    return new StageResult(
        "OCL from "
            + rules.get().items().size()
            + " design rules"
            + AgentReport.repairs(List.of(constrained)),
        List.of(Constraints.GENERATED),
        constrained.diagnostics(),
        AgentReport.of(run, Stage.CONSTRAIN, List.of(constrained)));
  }
}
