package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.console.Terminal;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.Today;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.time.Clock;
import java.util.List;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ParameterException;

/** The program {@code eventchain}. */
@Command(
    name = "eventchain",
    mixinStandardHelpOptions = true,
    versionProvider = Main.Version.class,
    description = "From written requirements to running, validated ROS 2 software.",
    footer = {
      "",
      "Exit codes: 0 success; 1 findings of severity error, or a failed verdict; 2 wrong usage or",
      "unreadable input; 3 something this machine lacks, or a defect in eventchain, which it reports;",
      "4 waiting for an answer; 128 plus the number of the signal that ended it: 129 for SIGHUP, 130",
      "for Ctrl-C, 143 for SIGTERM; every file is then either as it was or complete."
    })
public final class Main {

  /** The commands in the order of the help. */
  private static final List<Class<?>> COMMANDS =
      List.of(
          RunCommand.class,
          StageCommands.Design.class,
          StageCommands.Implement.class,
          StageCommands.Model.class,
          StageCommands.Constrain.class,
          ValidateCommand.class,
          GenerateCommand.class,
          CompileCommand.class,
          FormatCommand.class,
          StageCommands.Simulate.class,
          SuitesCommand.class,
          RequirementsCommand.class,
          AcceptCommand.class,
          CampaignCommand.class,
          SearchCommand.class,
          MutateCommand.class,
          MeasureCommand.class,
          EvaluateCommand.class,
          InitCommand.class,
          BenchCommand.class,
          MessagesCommand.class,
          DiagramCommand.class,
          ExportCommand.class,
          DescribeCommand.class,
          ExplainCommand.class,
          McpCommand.class,
          LspCommand.class,
          DoctorCommand.class);

  /** As wide as the lines of the descriptions. */
  private static final int HELP_WIDTH = 100;

  /** Provides the version. */
  static final class Version implements CommandLine.IVersionProvider {
    @Override
    public String[] getVersion() {
      return new String[] {"eventchain " + version()};
    }
  }

  /** Returns the version that the build wrote into the jar's manifest. */
  static String version() {
    String version = Main.class.getPackage().getImplementationVersion();
    return version == null ? "(development)" : version;
  }

  private Main() {}

  /** Runs the command line and ends the process with its exit code. */
  public static void main(String[] arguments) {
    PrintWriter out = writer(FileDescriptor.out);
    PrintWriter err = writer(FileDescriptor.err);
    // The process ends below by a halt, so only a signal leads here.
    Thread farewell = new Thread(() -> interrupted(err), "interrupted");
    Runtime.getRuntime().addShutdownHook(farewell);
    Thread.setDefaultUncaughtExceptionHandler((thread, problem) -> giveUp(problem, err));
    int code = run(arguments, out, err, Terminal.of(System.getenv()));
    if (out.checkError() && code == ExitCode.FINE) {
      err.println("eventchain: standard output cannot be written");
      code = ExitCode.INPUT;
    }
    err.flush();
    Runtime.getRuntime().halt(code);
  }

  /**
   * Ends the process if a background thread dies, so that no part of the work is silently missing.
   * Discards buffered output: it may contain a verdict.
   */
  private static void giveUp(Throwable problem, PrintWriter err) {
    try {
      failure(problem, err);
      err.flush();
    } finally {
      Runtime.getRuntime().halt(ExitCode.UNAVAILABLE);
    }
  }

  private static void interrupted(PrintWriter err) {
    err.println();
    err.println("eventchain: interrupted; every file is either as it was or complete");
    err.flush();
  }

  /**
   * Runs the command line.
   *
   * @param out results: verdicts and findings
   * @param err progress, and findings about the command itself
   * @param terminal the terminal behind {@code err}
   * @return the exit code, as {@link ExitCode} explains
   */
  static int run(String[] arguments, PrintWriter out, PrintWriter err, Terminal terminal) {
    Today today = Today.of(System.getenv(), Clock.systemUTC());
    CommandLine commandLine =
        commandLine(
            new Console(out, err, terminal, today), arguments.length == 0 ? "" : arguments[0]);
    commandLine.setOut(out).setErr(err);
    commandLine.setCaseInsensitiveEnumValuesAllowed(true);
    commandLine.setColorScheme(CommandLine.Help.defaultColorScheme(terminal.ansi()));
    commandLine.setParameterExceptionHandler((e, a) -> usage(e, err));
    commandLine.setExecutionExceptionHandler((e, c, p) -> failure(e, err));
    if (arguments.length == 0) {
      commandLine.usage(err);
      return ExitCode.INPUT;
    }
    try {
      return commandLine.execute(arguments);
    } catch (Error e) {
      // Uncaught, it would end the process with the exit code of a finding.
      return failure(e, err);
    }
  }

  /** Returns the command line with all commands, for documentation; it is not meant to run any. */
  public static CommandLine commandLine() {
    PrintWriter nowhere = new PrintWriter(Writer.nullWriter());
    Today today = Today.of(Map.of(), Clock.systemUTC());
    return commandLine(new Console(nowhere, nowhere, Terminal.of(Map.of()), today), "");
  }

  /**
   * Returns the command line with the named command, or with all: reading the options of all takes
   * time.
   */
  private static CommandLine commandLine(Console console, String name) {
    CommandLine commandLine = new CommandLine(new Main(), new Factory(console));
    List<Class<?>> named = COMMANDS.stream().filter(type -> nameOf(type).equals(name)).toList();
    (named.isEmpty() ? COMMANDS : named).forEach(commandLine::addSubcommand);
    commandLine.setUsageHelpWidth(HELP_WIDTH);
    return commandLine;
  }

  private static String nameOf(Class<?> command) {
    return command.getAnnotation(Command.class).name();
  }

  private static int usage(ParameterException e, PrintWriter err) {
    err.println("eventchain: " + e.getMessage());
    CommandLine.UnmatchedArgumentException.printSuggestions(e, err);
    err.println("Try 'eventchain " + hintFor(e) + "--help'.");
    return ExitCode.INPUT;
  }

  private static String hintFor(ParameterException e) {
    String name = e.getCommandLine().getCommandName();
    return name.equals("eventchain") ? "" : name + " ";
  }

  /** Handles failures outside the commands of a project, which report their own. */
  private static int failure(Throwable e, PrintWriter err) {
    Outcome outcome = Outcome.of(e);
    err.print(DiagnosticFormat.TEXT.render(outcome.diagnostics()));
    return outcome.exitCode();
  }

  private static PrintWriter writer(FileDescriptor descriptor) {
    return new PrintWriter(new FileOutputStream(descriptor), false, StandardCharsets.UTF_8);
  }
}
