package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.ProjectBench;
import dev.eventchain.pipeline.project.Configuration;
import dev.eventchain.pipeline.start.ProjectStart;
import dev.eventchain.pipeline.start.WorkspaceStart;
import dev.eventchain.project.SuppressionFile;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code init}: creates a project. */
@Command(
    name = "init",
    mixinStandardHelpOptions = true,
    description = {
      "Start a project.",
      "In a new or empty folder, it is a small example that runs as it is: emergency braking with a"
          + " radar, without a language model. In a folder with software-base/signals.json the"
          + " missing files of a project are added, with bench.yaml filled in from the signals, and"
          + " model/chain.xmi from software-base/components.json if these components form a"
          + " complete chain.",
      "With --from-workspace, it is a project around the nodes of a ROS 2 workspace, whose sources"
          + " are read and not run; what they do not say is asked, in"
          + " software-base/questions.json.",
      "With --nodl, it is one around nodes whose interfaces are described in NoDL 2;"
          + " with --from-mcap or --from-bag around the topics of a recording, which does not say"
          + " who writes and reads them.",
      "Existing files are not changed."
    })
final class InitCommand implements Callable<Integer> {

  @Parameters(arity = "0..1", paramLabel = "DIR", description = "The project's folder.")
  private Path folder;

  @Option(
      names = "--from-workspace",
      paramLabel = "WS",
      description =
          "A colcon workspace, or a folder of packages: its nodes in Python, those in C++ as far as"
              + " their topics are literals, and its launch files.")
  private Path workspace;

  @Option(
      names = "--launch",
      paramLabel = "FILE",
      description =
          "The launch file of the workspace that starts the software. By default the only one that"
              + " no other one includes.")
  private Path launch;

  @Option(
      names = "--nodl",
      paramLabel = "FILE",
      description =
          "An interface of a node in NoDL 2, NODE.nodl.yaml; repeat it for each node of the"
              + " software.")
  private List<Path> interfaces = List.of();

  @Option(
      names = {"--from-mcap", "--from-bag"},
      paramLabel = "PATH",
      description = "A recording: an MCAP file, or the folder that rosbag2 wrote.")
  private Path recording;

  @Option(
      names = "--messages",
      paramLabel = "FOLDER",
      description =
          "With --nodl: holds definitions of messages that are not standard, as PACKAGE/msg/NAME.msg"
              + " or as a colcon workspace; may be repeated.")
  private List<Path> messages = List.of();

  @Option(names = "--schema", description = "Print the JSON Schema of eventchain.yaml instead.")
  private boolean schema;

  @Option(
      names = "--suppressions-schema",
      description = "Print the JSON Schema of files of suppressions instead.")
  private boolean suppressionsSchema;

  @Spec private CommandSpec spec;

  private final Console console;

  InitCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() {
    if ((folder == null ? 0 : 1) + (schema ? 1 : 0) + (suppressionsSchema ? 1 : 0) != 1) {
      throw wrongUsage("name a project's folder, or use --schema or --suppressions-schema");
    }
    if (folder == null) {
      console.out().print(schema ? Configuration.schema() : SuppressionFile.schema());
      console.out().flush();
    } else {
      print(start());
    }
    return ExitCode.FINE;
  }

  private void print(ProjectStart.Started started) {
    started.files().forEach(file -> console.out().println(folder.resolve(file)));
    console.out().println();
    started
        .unfed()
        .ifPresent(
            unfed ->
                console
                    .out()
                    .println(
                        "There is no model/chain.xmi: "
                            + unfed
                            + ", which no component of components.json writes and no signal of"
                            + " signals.json provides. Write the model yourself, or have a"
                            + " language model design it from requirements.md."));
    String name = quoted(folder.toString());
    console.out().println("Next: eventchain bench " + name + "; eventchain run " + name);
    console.out().println("Once it passes: eventchain accept " + name);
    console.out().flush();
    console.err().print(DiagnosticFormat.TEXT.render(started.questions()));
    console.err().flush();
  }

  private ProjectStart.Started start() {
    boolean several = workspace != null && (!interfaces.isEmpty() || recording != null);
    if (several || (!interfaces.isEmpty() && recording != null)) {
      throw wrongUsage("--from-workspace, --nodl and --from-mcap exclude each other");
    }
    if (launch != null && workspace == null) {
      throw wrongUsage("--launch is about --from-workspace");
    }
    if (!messages.isEmpty() && interfaces.isEmpty()) {
      throw wrongUsage("--messages is about --nodl");
    }
    if (!interfaces.isEmpty()) {
      return WorkspaceStart.ofInterfaces(folder, interfaces, messages, ProjectBench::proposal);
    }
    if (recording != null) {
      return WorkspaceStart.ofRecording(folder, recording, ProjectBench::proposal);
    }
    if (workspace == null) {
      return ProjectStart.create(folder, ProjectBench::proposal);
    }
    return WorkspaceStart.create(
        folder,
        workspace,
        Optional.ofNullable(launch),
        ProjectBench::proposal,
        said -> console.err().println(said));
  }

  private ParameterException wrongUsage(String message) {
    return new ParameterException(spec.commandLine(), message);
  }

  /** Returns the name quoted for a shell. */
  private static String quoted(String name) {
    return name.matches("[A-Za-z0-9_./+-]+") ? name : "'" + name.replace("'", "'\\''") + "'";
  }
}
