package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.pipeline.engine.PipelineRun;
import dev.eventchain.pipeline.engine.StandingResults;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.RunResult;
import java.nio.file.Path;
import java.util.Optional;

/** Runs the requested stages of a project in order, as far as possible. */
public final class Pipeline {

  private Pipeline() {}

  /**
   * Runs stages of a project.
   *
   * @return the result of the run with all findings, also if a stage could not continue
   * @throws DiagnosticException INPUT if the output folder cannot be written or is in use
   */
  public static RunResult run(Project project, RunOptions options, Progress progress) {
    return PipelineRun.run(project, options, progress, Optional.empty()).result();
  }

  /**
   * Withdraws the verdict of an earlier run from an output folder, for a run with a verdict that
   * could not begin. Does nothing if there is no verdict or another run is in progress.
   */
  public static void withdrawVerdict(Path output) {
    StandingResults.withdrawVerdict(output);
  }
}
