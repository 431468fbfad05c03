package dev.eventchain.maven;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.Pipeline;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Answers;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.RunResult;
import dev.eventchain.pipeline.run.SimulationOptions;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.run.Stages;
import dev.eventchain.project.ProjectLayout;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.apache.maven.plugins.annotations.Parameter;

/** A goal that may run stages of an event chain project. */
abstract class ChainMojo extends EventchainMojo {

  /**
   * Folder of the event chain, with {@code eventchain.yaml}. By default the module's folder, if it
   * contains that file.
   */
  @Parameter(property = "eventchain.chain")
  private File chain;

  /**
   * Folder of the chain's results; by default a folder with the chain's name next to the reports.
   */
  @Parameter(property = "eventchain.results")
  private File results;

  /**
   * Source of language models' answers: {@code replay}, {@code live}, {@code handoff:FOLDER} and so
   * on; by default that of {@code eventchain.yaml}.
   */
  @Parameter(property = "eventchain.llm")
  private String llm;

  /** True to replace results that were edited by hand. */
  @Parameter(property = "eventchain.overwrite", defaultValue = "false")
  private boolean overwrite;

  /** Returns what becomes of results that were edited by hand. */
  final OnEdit onEdit() {
    return overwrite ? OnEdit.OVERWRITE : OnEdit.KEEP;
  }

  /** Returns the folder of the event chain; empty if neither the pom nor the module has one. */
  final Optional<Path> chain() {
    return Optional.ofNullable(chain)
        .or(() -> Optional.of(basedir()).filter(ChainMojo::isChain))
        .map(Places::shown);
  }

  private static boolean isChain(File folder) {
    return Files.exists(folder.toPath().resolve(ProjectLayout.CONFIGURATION));
  }

  /** Returns the folder for the results of the chain in a folder. */
  final Path resultsOf(Path folder) {
    if (results != null) {
      return Places.shown(results);
    }
    String name = folder.toAbsolutePath().normalize().getFileName().toString();
    return Places.shown(new File(reportsDirectory(), name));
  }

  /** Runs stages of the chain, except for those that are up to date. */
  final Outcome run(Path folder, Stage last) {
    return run(folder, last, SimulationOptions.DEFAULT);
  }

  /** As above, with options of the simulation. */
  final Outcome run(Path folder, Stage last, SimulationOptions simulation) {
    Path output = resultsOf(folder);
    try {
      return run(Project.open(folder), output, Stages.upTo(last), simulation);
    } catch (DiagnosticException e) {
      // The chain or its suppressions cannot be read, so the subject of a verdict is unknown.
      if (last.compareTo(Stage.SIMULATE) >= 0) {
        Pipeline.withdrawVerdict(output);
      }
      throw e;
    }
  }

  /** Checks the chain's model, and creates it before if there is none. */
  final Outcome validate(Path folder) {
    Project project = Project.open(folder);
    Path output = resultsOf(folder);
    Stage first = project.isReadyToValidate(output) ? Stage.VALIDATE : Stage.DESIGN;
    Stages stages = new Stages(first, Stage.VALIDATE, false);
    return run(project, output, stages, SimulationOptions.DEFAULT);
  }

  private Outcome run(Project project, Path output, Stages stages, SimulationOptions simulation) {
    RunOptions options =
        new RunOptions(
            output,
            stages,
            new Answers(Optional.ofNullable(llm), false),
            onEdit(),
            simulation,
            Optional.empty(),
            suppressions(project.suppressions()),
            timeLimit());
    RunResult result = Pipeline.run(project, options, new LogProgress(getLog()));
    print(result);
    return Outcome.of(result);
  }

  private void print(RunResult result) {
    for (RunResult.ScenarioLine line : result.scenarios()) {
      print(line.tested(), line.passed(), line.name() + ": " + line.text());
    }
    for (RunResult.FaultLine line : result.faults()) {
      print(line.tested(), line.passed(), line.name() + ": " + line.text());
    }
    if (!result.scenarios().isEmpty()) {
      getLog().info(result.verdict() + ": " + result.summary());
    }
    result.report().ifPresent(report -> getLog().info("Report: " + report));
  }

  private void print(boolean tested, boolean passed, String text) {
    String word = passed ? "passed" : "FAILED";
    getLog().info((tested ? word : "-") + "  " + text);
  }
}
