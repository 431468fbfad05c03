package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.project.Acceptance;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.project.AcceptedTexts;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code accept}: records the texts of requirements whose evidence somebody has looked at. */
@Command(
    name = "accept",
    mixinStandardHelpOptions = true,
    description = {
      "Record that you have looked at the scenarios and constraints that prove requirements.",
      "Their texts are recorded in DIR/accepted.yaml, which belongs into version control. When a text"
          + " changes later, its requirement counts as not tested until it is accepted again."
    })
final class AcceptCommand implements Callable<Integer> {

  @Parameters(index = "0", paramLabel = "DIR", description = "The project's folder.")
  private Path folder;

  @Parameters(
      index = "1..*",
      paramLabel = "REQUIREMENT",
      description = "The ids of the requirements (default: all).")
  private List<String> requirements = List.of();

  @Option(
      names = "--by",
      paramLabel = "NAME",
      description = "Who has looked at them (default: the name of the user).")
  private String by = System.getProperty("user.name", "");

  @Spec private CommandSpec spec;

  private final Console console;

  AcceptCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() {
    if (by.isBlank()) {
      throw new ParameterException(spec.commandLine(), "say who has looked at them: --by NAME");
    }
    Project project = Project.open(folder);
    AcceptedTexts accepted =
        Acceptance.record(project, requirements, by.strip(), console.today().date());
    String ids =
        String.join(
            ", ", accepted.entries().stream().map(AcceptedTexts.Entry::requirement).toList());
    console.out().println("Accepted in " + project.acceptedFile() + ": " + ids);
    console.out().flush();
    return ExitCode.FINE;
  }
}
