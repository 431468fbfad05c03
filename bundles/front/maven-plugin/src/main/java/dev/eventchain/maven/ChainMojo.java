package dev.eventchain.maven;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.Pipeline;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.RunOptions.Driver;
import dev.eventchain.pipeline.run.RunResult;
import dev.eventchain.pipeline.run.Stage;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.apache.maven.plugins.annotations.Parameter;

/** A goal that may run stages of an event chain's project. */
abstract class ChainMojo extends EventchainMojo {

  /**
   * The folder of an event chain: it holds {@code eventchain.yaml}. Without it, the module's own
   * folder, if that holds one.
   */
  @Parameter(property = "eventchain.chain")
  private File chain;

  /**
   * Where the chain's results go; without it, a folder with the chain's name next to the reports.
   */
  @Parameter(property = "eventchain.results")
  private File results;

  /**
   * Where the answers of language models come from: {@code replay}, {@code live}, {@code
   * handoff:FOLDER} and so on; without it, as {@code eventchain.yaml} says.
   */
  @Parameter(property = "eventchain.llm")
  private String llm;

  /** Whether files among the results that were edited by hand are replaced. */
  @Parameter(property = "eventchain.overwrite", defaultValue = "false")
  private boolean overwrite;

  final boolean overwrite() {
    return overwrite;
  }

  /** The folder of the event chain; empty if the pom names none and the module's is none. */
  final Optional<Path> chain() {
    return Optional.ofNullable(chain)
        .or(() -> Optional.of(basedir()).filter(ChainMojo::isChain))
        .map(Places::shown);
  }

  private static boolean isChain(File folder) {
    return Files.exists(folder.toPath().resolve("eventchain.yaml"));
  }

  /** Where the results of the chain in a folder go. */
  final Path resultsOf(Path folder) {
    if (results != null) {
      return Places.shown(results);
    }
    String name = folder.toAbsolutePath().normalize().getFileName().toString();
    return Places.shown(new File(reportsDirectory(), name));
  }

  /** Runs stages of the chain, those that nothing has changed for left out. */
  final Outcome run(Path folder, Stage last) {
    return run(folder, last, Driver.LOCKSTEP, Optional.empty());
  }

  /** As above, with a way to simulate, and faults. */
  final Outcome run(Path folder, Stage last, Driver driver, Optional<Path> faults) {
    Path output = resultsOf(folder);
    try {
      return run(Project.open(folder), output, Stage.DESIGN, last, driver, faults);
    } catch (DiagnosticException e) {
      // The chain or its suppressions cannot be read, so it is unknown what a verdict would be
      // about.
      if (last.compareTo(Stage.SIMULATE) >= 0) {
        Pipeline.withdrawVerdict(output);
      }
      throw e;
    }
  }

  /** Checks the chain's model, and creates it first if there is none. */
  final Outcome validate(Path folder) {
    Project project = Project.open(folder);
    Path output = resultsOf(folder);
    Stage first = project.isReadyToValidate(output) ? Stage.VALIDATE : Stage.DESIGN;
    return run(project, output, first, Stage.VALIDATE, Driver.LOCKSTEP, Optional.empty());
  }

  private Outcome run(
      Project project, Path output, Stage first, Stage last, Driver driver, Optional<Path> faults) {
    RunOptions options =
        new RunOptions(
            output,
            first,
            last,
            false,
            Optional.ofNullable(llm),
            false,
            overwrite,
            List.of(),
            driver,
            false,
            Optional.empty(),
            faults,
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
