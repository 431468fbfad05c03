package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.ProjectBench;
import dev.eventchain.pipeline.project.Project;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code bench}: lists the simulated world's inputs and outputs, and how a project uses them. */
@Command(
    name = "bench",
    mixinStandardHelpOptions = true,
    description = {
      "List what the simulated world provides and what the vehicle accepts.",
      "It also shows how the project's topics are connected to them (bench.yaml; without one,"
          + " CARLA's topics).",
      "If the project's chain has been designed, it is checked against this, too."
    })
final class BenchCommand implements Callable<Integer> {

  @Parameters(arity = "0..1", paramLabel = "DIR", description = "The project's folder.")
  private Path folder;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "FOLDER",
      description = "Where the project's results are (default: DIR/out).")
  private Path output;

  @Option(names = "--schema", description = "Print the JSON Schema of bench.yaml instead.")
  private boolean schema;

  @Option(names = "--scenario-schema", description = "Print the JSON Schema of scenarios instead.")
  private boolean scenarioSchema;

  @Option(names = "--faults-schema", description = "Print the JSON Schema of --faults instead.")
  private boolean faultsSchema;

  @Spec private CommandSpec spec;

  private final Console console;

  BenchCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() {
    List<String> schemas =
        Stream.of(
                schema ? ProjectBench.schema() : "",
                scenarioSchema ? ProjectBench.scenarioSchema() : "",
                faultsSchema ? ProjectBench.faultsSchema() : "")
            .filter(it -> !it.isEmpty())
            .toList();
    if (schemas.size() + (folder == null ? 0 : 1) != 1) {
      throw new ParameterException(
          spec.commandLine(),
          "name a project's folder, or use --schema, --scenario-schema or --faults-schema");
    }
    if (!schemas.isEmpty()) {
      console.out().print(schemas.get(0));
      console.out().flush();
      return ExitCode.FINE;
    }
    Project project = Project.open(folder);
    ProjectBench bench =
        ProjectBench.of(project, output == null ? project.defaultOutput() : output);
    console.out().print(bench.text());
    console.out().flush();
    console.err().print(DiagnosticFormat.TEXT.render(bench.diagnostics()));
    console.err().flush();
    return Diagnostic.anyError(bench.diagnostics()) ? ExitCode.FINDINGS : ExitCode.FINE;
  }
}
