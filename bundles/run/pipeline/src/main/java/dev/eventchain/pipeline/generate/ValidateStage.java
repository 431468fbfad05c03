package dev.eventchain.pipeline.generate;

import dev.eventchain.check.ChainChecks;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.results.Validated;
import dev.eventchain.pipeline.results.Validation;
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
    Validation validation =
        ProjectChecks.report(SourceLocation.of(run.model()).file(), outcome.constraints());
    List<String> files = new ArrayList<>();
    files.add(SourceLocation.of(run.model()).file());
    files.addAll(run.project().constraintNames(run.options().output()));
    return new StageResult(
        outcome.words(),
        List.of(),
        outcome.diagnostics(),
        new Validated(validation),
        outcome.coverage(files));
  }
}
