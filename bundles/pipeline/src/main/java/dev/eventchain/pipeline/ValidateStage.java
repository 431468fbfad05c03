package dev.eventchain.pipeline;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.ocl.OclResult;
import java.util.ArrayList;
import java.util.List;

/** The model against its constraints. */
final class ValidateStage implements StageWork {

  @Override
  public void fingerprint(RunContext run, Fingerprint fingerprint) {
    // Always runs: its findings should be fresh.
  }

  @Override
  public boolean skippable() {
    return false;
  }

  @Override
  public StageResult execute(RunContext run) {
    RunContext.LoadedChain model = run.loadChain(run.model());
    Constraints constraints = Constraints.of(run);
    ChainOrigins origins = ChainOrigins.of(run, model);
    OclResult result = constraints.check(model.chain(), origins::locate);
    ObjectNode report = JsonNodeFactory.instance.objectNode();
    report.set("validation", Constraints.report(SourceLocation.of(run.model()).file(), result));
    List<Diagnostic> found = new ArrayList<>(result.diagnostics());
    found.addAll(run.softwareBase().check(model.chain(), origins::locate));
    List<String> files = new ArrayList<>();
    files.add(SourceLocation.of(run.model()).file());
    files.addAll(Constraints.files(run));
    Coverage coverage = Constraints.coverage(files, result);
    return new StageResult(Constraints.words(result), List.of(), found, report, coverage);
  }
}
