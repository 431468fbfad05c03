package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.MessageDefinitions;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

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
      arity = "0..*",
      paramLabel = "FOLDER",
      description =
          "Holds PACKAGE/msg/NAME.msg or NAME.idl, as software-base/msg of a project does, or is a "
              + "colcon workspace; a later one hides an earlier one. None for standard messages alone, with --ros-distro.")
  private List<Path> folders = new ArrayList<>();

  @Option(
      names = "--ros-distro",
      paramLabel = "NAME",
      completionCandidates = Distributions.class,
      description =
          "The release of ROS 2 whose standard messages they use: ${COMPLETION-CANDIDATES}. By default "
              + "that of the project around the first folder, or humble.")
  private String distribution;

  @Spec private CommandSpec spec;

  private final Console console;

  /** The known releases of ROS 2. */
  private static final class Distributions implements Iterable<String> {
    @Override
    public Iterator<String> iterator() {
      return MessageDefinitions.distributions().iterator();
    }
  }

  MessagesCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() {
    if (folders.isEmpty() && distribution == null) {
      throw new ParameterException(spec.commandLine(), "name a folder, or --ros-distro");
    }
    if (distribution != null && !MessageDefinitions.distributions().contains(distribution)) {
      String known = String.join(" or ", MessageDefinitions.distributions());
      throw new ParameterException(
          spec.commandLine(), "--ros-distro is " + known + ", not '" + distribution + "'");
    }
    MessageDefinitions definitions =
        MessageDefinitions.of(Optional.ofNullable(distribution), folders);
    console.out().print(definitions.json());
    console.out().flush();
    console.err().print(DiagnosticFormat.TEXT.render(definitions.diagnostics()));
    console.err().flush();
    return Diagnostic.anyError(definitions.diagnostics()) ? ExitCode.FINDINGS : ExitCode.FINE;
  }
}
