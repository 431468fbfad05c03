package dev.eventchain.pipeline.generate;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.check.ChainChecks;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.ProjectChecks;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageResult;
import dev.eventchain.pipeline.stage.StageWork;
import java.util.ArrayList;
import java.util.List;

/** Checks the model against its constraints and contracts. */
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
    ChainChecks.Outcome outcome = run.chain().checks();
    ObjectNode report = JsonNodeFactory.instance.objectNode();
    report.set(
        "validation",
        ProjectChecks.report(SourceLocation.of(run.model()).file(), outcome.constraints()));
    List<String> files = new ArrayList<>();
    files.add(SourceLocation.of(run.model()).file());
    files.addAll(run.project().constraintNames(run.options().output()));
    return new StageResult(
        outcome.words(), List.of(), outcome.diagnostics(), report, outcome.coverage(files));
  }
}
