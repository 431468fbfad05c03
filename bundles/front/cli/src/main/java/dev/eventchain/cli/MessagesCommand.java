package dev.eventchain.cli;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticFormat;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.MessageDefinitions;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code messages}: message definitions for nodes that are run without the simulation. */
@Command(
    name = "messages",
    mixinStandardHelpOptions = true,
    description = {
      "Print message definitions as JSON, for nodes and tests that you run without ROS 2:",
      "'python -m eventchain_ros2 --messages FILE NODE.py' and the plugin of pytest read it.",
      "Definitions that ROS 2 would refuse are reported with their lines, and nothing is printed."
    })
final class MessagesCommand implements Callable<Integer> {

  @Parameters(
      arity = "1..*",
      paramLabel = "FOLDER",
      description =
          "Holds PACKAGE/msg/NAME.msg or NAME.idl, as software-base/msg of a project does; a later one "
              + "hides an earlier one.")
  private List<Path> folders = new ArrayList<>();

  private final Console console;

  MessagesCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() {
    MessageDefinitions definitions = MessageDefinitions.of(folders);
    console.out().print(definitions.json());
    console.out().flush();
    console.err().print(DiagnosticFormat.TEXT.render(definitions.diagnostics()));
    console.err().flush();
    return Diagnostic.anyError(definitions.diagnostics()) ? ExitCode.FINDINGS : ExitCode.FINE;
  }
}
