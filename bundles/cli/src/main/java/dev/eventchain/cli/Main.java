package dev.eventchain.cli;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticFormat;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ParameterException;

/** The program {@code eventchain}. */
@Command(
    name = "eventchain",
    mixinStandardHelpOptions = true,
    versionProvider = Main.Version.class,
    subcommands = {
      RunCommand.class,
      StageCommands.Design.class,
      StageCommands.Implement.class,
      StageCommands.Model.class,
      StageCommands.Constrain.class,
      ValidateCommand.class,
      GenerateCommand.class,
      StageCommands.Simulate.class,
    },
    description = "From written requirements to running, validated ROS 2 software.",
    footer = {
      "",
      "Exit codes: 0 fine; 1 findings of severity error, or a failed verdict; 2 wrong usage or",
      "unreadable input; 3 something this machine lacks, or a defect of eventchain, which says so;",
      "4 waiting for an answer; 130 interrupted."
    })
public final class Main {

  /** The version that the build wrote into the jar's manifest. */
  static final class Version implements CommandLine.IVersionProvider {
    @Override
    public String[] getVersion() {
      String version = Main.class.getPackage().getImplementationVersion();
      return new String[] {"eventchain " + (version == null ? "(development)" : version)};
    }
  }

  private Main() {}

  /** Runs the command line and ends the process with its exit code. */
  public static void main(String[] arguments) {
    PrintWriter out = writer(FileDescriptor.out);
    PrintWriter err = writer(FileDescriptor.err);
    // The end below is a halt, so only a signal gets here.
    Thread farewell = new Thread(() -> interrupted(err), "interrupted");
    Runtime.getRuntime().addShutdownHook(farewell);
    int code = run(arguments, out, err, Terminal.of(System.getenv()));
    if (out.checkError() && code == ExitCode.FINE) {
      err.println("eventchain: standard output cannot be written");
      code = ExitCode.INPUT;
    }
    err.flush();
    Runtime.getRuntime().halt(code);
  }

  private static void interrupted(PrintWriter err) {
    err.println();
    err.println("eventchain: interrupted; every file is as it was or complete");
    err.flush();
  }

  /**
   * Runs the command line.
   *
   * @param out results: verdicts and findings
   * @param err progress, and findings about the command itself
   * @param terminal what {@code err} is written to
   * @return the exit code, as {@link ExitCode} explains
   */
  static int run(String[] arguments, PrintWriter out, PrintWriter err, Terminal terminal) {
    CommandLine commandLine = new CommandLine(new Main(), new Factory(out, err, terminal));
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
      // Left to Java, it would end the process with the code of a finding.
      return defect(e, err);
    }
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

  /** Every failure is a finding; one that is not is a defect of this program, and says so. */
  private static int failure(Exception e, PrintWriter err) {
    if (e instanceof DiagnosticException diagnostics) {
      err.print(DiagnosticFormat.TEXT.render(diagnostics.diagnostics()));
      return ExitCode.of(diagnostics.reason());
    }
    return defect(e, err);
  }

  /** Says that this program itself is wrong, with the place in its code. */
  private static int defect(Throwable e, PrintWriter err) {
    Optional<Diagnostic> memory = MemoryFinding.in(e);
    if (memory.isPresent()) {
      err.print(DiagnosticFormat.TEXT.render(List.of(memory.get())));
      return ExitCode.UNAVAILABLE;
    }
    StackTraceElement[] stack = e.getStackTrace();
    String place = stack.length == 0 ? "" : " at " + stack[0];
    Diagnostic defect =
        Diagnostic.error(
                "eventchain.defect",
                "This is a defect of eventchain: " + e + place,
                SourceLocation.NONE)
            .withHint("Report it with the command and the input that led to it.");
    err.print(DiagnosticFormat.TEXT.render(List.of(defect)));
    return ExitCode.UNAVAILABLE;
  }

  private static PrintWriter writer(FileDescriptor descriptor) {
    return new PrintWriter(new FileOutputStream(descriptor), false, StandardCharsets.UTF_8);
  }
}
