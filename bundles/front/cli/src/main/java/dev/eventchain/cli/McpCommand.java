package dev.eventchain.cli;

import dev.eventchain.mcp.AgentServer;
import dev.eventchain.pipeline.ExitCode;
import java.io.File;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mcp}: serves a coding agent. */
@Command(
    name = "mcp",
    mixinStandardHelpOptions = true,
    description = {
      "Serve a coding agent over the Model Context Protocol, on standard input and output.",
      "An agent starts this command itself, by its configuration. It can then start a project,"
          + " check it, run it to its verdict, read what was measured, and try changes on a copy."
          + " It reads and changes nothing outside DIR, and cannot change settings, suppressions,"
          + " limits or confinement. The server ends when its input ends, and what it runs with it."
    })
final class McpCommand implements Callable<Integer> {

  @Parameters(
      arity = "0..1",
      paramLabel = "DIR",
      defaultValue = ".",
      description = "The folder of a project, or of several (default: the current one).")
  private Path folder;

  @Spec private CommandSpec spec;

  McpCommand() {}

  @Override
  public Integer call() {
    FileOutputStream out = new FileOutputStream(FileDescriptor.out);
    // Every line of standard output is a message; what a library prints must not be among them.
    System.setOut(System.err);
    try {
      AgentServer server =
          AgentServer.open(
              new FileInputStream(FileDescriptor.in), out, folder, program(), Main.version());
      Runtime.getRuntime().addShutdownHook(new Thread(server::stop, "end of the server"));
      server.serve();
      return ExitCode.FINE;
    } catch (IOException e) {
      throw new ParameterException(
          spec.commandLine(), "there is no folder " + folder + " to serve", e);
    }
  }

  /** Returns what starts this program again, as it was started. */
  private static List<String> program() {
    List<String> words = new ArrayList<>();
    words.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    words.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
    String classPath =
        Stream.of(System.getProperty("java.class.path").split(File.pathSeparator, -1))
            .map(entry -> Path.of(entry).toAbsolutePath().toString())
            .collect(Collectors.joining(File.pathSeparator));
    words.addAll(List.of("-cp", classPath, Main.class.getName()));
    return words;
  }
}
