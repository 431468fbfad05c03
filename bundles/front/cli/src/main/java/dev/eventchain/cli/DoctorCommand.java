package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.pipeline.Doctor;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.project.Project;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code doctor}: checks whether this machine has everything that runs need. */
@Command(
    name = "doctor",
    mixinStandardHelpOptions = true,
    description = {
      "Report whether this machine has what runs need.",
      "It also says which language-model services can be reached: those of a project's models, or"
          + " all known ones. Keys are never shown. Nothing is installed: if Python packages are"
          + " missing, it checks whether they can be fetched, or come from the folder that"
          + " EVENTCHAIN_WHEELS names."
    })
final class DoctorCommand implements Callable<Integer> {

  @Parameters(arity = "0..1", paramLabel = "DIR", description = "The project's folder.")
  private Path folder;

  private final Console console;

  DoctorCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() {
    Optional<Project> project = Optional.ofNullable(folder).map(Project::open);
    List<Doctor.Check> checks =
        Doctor.look(project, System::getenv, line -> console.err().println(line));
    int width = checks.stream().mapToInt(check -> check.name().length()).max().orElse(0);
    for (Doctor.Check check : checks) {
      String state = check.fine() ? "fine" : check.needed() ? "missing" : "not there";
      console.out().printf("%-" + width + "s  %-9s  %s%n", check.name(), state, check.words());
    }
    console.out().flush();
    return checks.stream().allMatch(check -> check.fine() || !check.needed())
        ? ExitCode.FINE
        : ExitCode.UNAVAILABLE;
  }
}
