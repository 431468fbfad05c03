package dev.eventchain.documentation.examples;

import dev.eventchain.pipeline.Pipeline;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.RunResult;
import java.nio.file.Path;

/** Takes a project from its requirements to the verdict of its scenarios. */
public final class RunSimulation {

  private RunSimulation() {}

  /** Returns the verdict with all findings; the files are below the output folder. */
  public static RunResult run(Path project, Path output) {
    return Pipeline.run(Project.open(project), RunOptions.of(output), Progress.NONE);
  }
}
