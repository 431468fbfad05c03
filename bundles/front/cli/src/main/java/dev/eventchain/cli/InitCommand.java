package dev.eventchain.cli;

import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.ProjectBench;
import dev.eventchain.pipeline.start.ProjectStart;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

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
      "Existing files are not changed."
    })
final class InitCommand implements Callable<Integer> {

  @Parameters(paramLabel = "DIR", description = "The project's folder.")
  private Path folder;

  private final Console console;

  InitCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() {
    ProjectStart.Started started = ProjectStart.create(folder, ProjectBench::proposal);
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
    return ExitCode.FINE;
  }

  /** Returns the name quoted for a shell. */
  private static String quoted(String name) {
    return name.matches("[A-Za-z0-9_./+-]+") ? name : "'" + name.replace("'", "'\\''") + "'";
  }
}
