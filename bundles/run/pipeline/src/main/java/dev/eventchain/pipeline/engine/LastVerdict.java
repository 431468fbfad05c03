package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.results.VerdictFile;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.ProjectLayout;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** The verdict in the output folder, for a run that simulates nothing. */
final class LastVerdict {

  private LastVerdict() {}

  /**
   * Returns the finding that a simulation did not pass, or that its verdict cannot be read; empty
   * if it passed, or there was none.
   */
  static Optional<Diagnostic> notPassed(RunContext run) {
    return run.output().read(ProjectLayout.VERDICT).flatMap(bytes -> notPassed(run, bytes));
  }

  private static Optional<Diagnostic> notPassed(RunContext run, byte[] bytes) {
    VerdictFile verdict;
    try {
      verdict = ResultJson.read(bytes, VerdictFile.class);
    } catch (IOException e) {
      return Optional.of(outdated(run)); // changed by others, or by another version
    }
    List<VerdictFile.Scenario> scenarios = verdict.scenarios();
    if (scenarios.isEmpty() || verdict.passed()) {
      return Optional.empty();
    }
    long passed = scenarios.stream().filter(VerdictFile.Scenario::passed).count();
    String counted = passed + " of " + Coverage.counted(scenarios.size(), "scenario");
    return Optional.of(
        Diagnostic.of(
                EngineRules.VERDICT_FAILED,
                "The last simulation did not pass (" + counted + " passed). Its report stays.",
                SourceLocation.of(run.file(ProjectLayout.VERDICT)))
            .withHint("Run '" + run.command("") + "' for a verdict about the current files."));
  }

  /** Returns the finding that no passed verdict is about the current files. */
  static Diagnostic outdated(RunContext run) {
    return Diagnostic.of(
            EngineRules.STAGE_OUTDATED,
            "There is no verdict about the current files that a report could show.",
            SourceLocation.of(run.file(ProjectLayout.VERDICT)))
        .withHint("Run '" + run.command("--from simulate") + "'.");
  }
}
