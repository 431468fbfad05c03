package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.campaign.Suites;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code suites}: lists the suites that come with the program. */
@Command(
    name = "suites",
    mixinStandardHelpOptions = true,
    description = {
      "List the suites that come with the program: the protocol that each is after, its campaigns, and"
          + " how many cases they have.",
      "'simulate DIR --suite NAME' simulates the cases of one."
    })
final class SuitesCommand implements Callable<Integer> {

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "text",
      description = "The format of the list: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
  private RequirementsCommand.Format format;

  private final Console console;

  SuitesCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() {
    Suites.Listing list = Suites.list();
    console.out().print(format == RequirementsCommand.Format.JSON ? list.json() : list.text());
    console.out().flush();
    return ExitCode.FINE;
  }
}
