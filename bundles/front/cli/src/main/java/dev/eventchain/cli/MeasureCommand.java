package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.options.LlmOptions;
import dev.eventchain.cli.options.ScenarioOptions;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.measure.TraceMeasuring;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.run.Stages;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code measure}: compares a recorded trace of ROS 2 with a project's chain. */
@Command(
    name = "measure",
    mixinStandardHelpOptions = true,
    description = {
      "Measure a project's chain in a trace of its nodes that ros2_tracing has recorded (LTTng):",
      "execution times and periods of components, the ways of messages, and the latencies that the",
      "model bounds. What exceeds or refutes the model, and what the trace leaves open, is reported.",
      "Results are in OUTPUT/traced: measurements.json, the measured model, and a change of",
      "components.json that states longer execution times. Nothing of the project is changed."
    },
    synopsisHeading = "Usage:%n",
    customSynopsis = "eventchain measure DIR TRACE [OPTIONS]")
final class MeasureCommand extends ProjectCommand {

  private final Console console;

  @Parameters(index = "0", paramLabel = "DIR", description = "The project's folder.")
  private Path folder;

  @Parameters(
      index = "1",
      paramLabel = "TRACE",
      description =
          "The folder of the trace, which babeltrace2 reads, or the text of 'babeltrace2"
              + " --component=sink.text.details FOLDER'.")
  private Path trace;

  MeasureCommand(Console console) {
    super(console);
    this.console = console;
  }

  @Override
  Outcome work() {
    Project project = Project.open(folder);
    Path output = outputOf(project);
    if (project.editedModel().isEmpty()) {
      Outcome made =
          execute(project, Stages.upTo(Stage.MODEL), new LlmOptions(), new ScenarioOptions());
      if (made.exitCode() != ExitCode.FINE) {
        return made;
      }
    }
    Path model = project.model(output).orElseThrow();
    Suppressions suppressions = suppressions(project);
    TraceMeasuring measured =
        TraceMeasuring.of(project, model, output, trace, timeLimit(), suppressions, onEdit());
    if (format() == DiagnosticFormat.TEXT) {
      console.out().print(measured.text());
    }
    return Outcome.of(measured.files(), suppressions);
  }
}
