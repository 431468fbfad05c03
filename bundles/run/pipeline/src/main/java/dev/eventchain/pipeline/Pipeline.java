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

/** Runs the stages of a project in order, as far as they are asked for and can go. */
public final class Pipeline {

  private Pipeline() {}

  /**
   * Runs stages of a project.
   *
   * @return how the run ended, with everything that was found; also when a stage could not continue
   * @throws DiagnosticException INPUT if the output folder cannot be written or is in use
   */
  public static RunResult run(Project project, RunOptions options, Progress progress) {
    return PipelineRun.run(project, options, progress, Optional.empty()).result();
  }

  /**
   * Withdraws the verdict that an earlier run has left in an output folder, for a run that was to
   * reach one and could not even be begun. Nothing happens where there is not a verdict, or another
   * run is at work.
   */
  public static void withdrawVerdict(Path output) {
    StandingResults.withdrawVerdict(output);
  }
}
