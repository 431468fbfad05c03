package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.options.ReferenceOptions;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.AnyModel;
import dev.eventchain.pipeline.Outcome;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code describe}: lists what a metamodel has. */
@Command(
    name = "describe",
    mixinStandardHelpOptions = true,
    description = {
      "List the packages, classes, features and operations of metamodels.",
      "Without FILE, those of event chains."
    })
final class DescribeCommand extends ProjectCommand {

  private final Console console;

  @Parameters(
      arity = "0..*",
      paramLabel = "FILE.ecore|URI",
      description = "The metamodels, by their files or their nsURIs.")
  private List<Path> metamodels = List.of();

  @Mixin private ReferenceOptions references = new ReferenceOptions();

  DescribeCommand(Console console) {
    super(console);
    this.console = console;
  }

  @Override
  boolean printsResult() {
    return true;
  }

  @Override
  Outcome work() {
    if (namesOutput()) {
      throw wrongUsage("nothing is written: leave out -o and --overwrite");
    }
    String text = AnyModel.describe(metamodels, references.folders());
    if (format() == DiagnosticFormat.TEXT) {
      console.out().print(text);
    }
    return Outcome.of(Coverage.NONE, List.of(), List.of());
  }
}
