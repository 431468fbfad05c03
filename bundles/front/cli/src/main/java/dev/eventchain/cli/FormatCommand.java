package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.format.Formatting;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code format}: formats constraints, templates and the YAML of projects. */
@Command(
    name = "format",
    mixinStandardHelpOptions = true,
    description = {
      "Format constraints (*.ocl), templates (*.mtl) and YAML, as an editor does with 'eventchain lsp'.",
      "What they say never changes: lines, comments and blank lines stay, and so do line ends. In a"
          + " folder, YAML counts in projects only; results, recordings, what is hidden, folders of"
          + " build tools and links are left out. A file with a syntax error is left as it is, which"
          + " is a finding.",
      "With --check, nothing is written, and each file that is not formatted is a finding."
    },
    synopsisHeading = "Usage:%n",
    customSynopsis = "eventchain format [--check] [FILE|FOLDER...] [OPTIONS]")
final class FormatCommand extends ProjectCommand {

  private static final int WIDEST = 16;

  @Parameters(
      arity = "0..*",
      paramLabel = "FILE|FOLDER",
      description =
          "Files, and folders of which all files are meant (default: the project in the current"
              + " folder, or around it).")
  private List<Path> inputs = List.of();

  @Option(names = "--check", description = "Write nothing, and report what would change.")
  private boolean check;

  @Option(
      names = "--indent",
      paramLabel = "COLUMNS",
      defaultValue = "" + Formatting.COLUMNS,
      description =
          "The width of a level of indentation, from 1 to 16 (default: ${DEFAULT-VALUE}).")
  private int indent;

  FormatCommand(Console console) {
    super(console);
  }

  @Override
  Outcome work() {
    if (namesOutput()) {
      throw wrongUsage("files are formatted where they are: leave out -o and --overwrite");
    }
    if (indent < 1 || indent > WIDEST) {
      throw wrongUsage("an indentation has from 1 to " + WIDEST + " columns: --indent 4");
    }
    List<Path> named = inputs.isEmpty() ? List.of(here()) : inputs;
    Suppressions outside = suppressions();
    Formatting.Result result = Formatting.of(named, indent, !check);
    result.changed().forEach(file -> print("formatted " + file));
    return Formatting.outcome(
        result,
        project ->
            project
                .filter(it -> suppressionsFile().isEmpty())
                .map(this::suppressions)
                .orElse(outside));
  }

  /** Returns the project in the current folder, or around it, seen from there. */
  private static Path here() {
    Path here = Path.of("").toAbsolutePath();
    return ProjectFolder.around(here.resolve("file"))
        .map(project -> here.relativize(project.folder()))
        .orElseGet(
            () -> {
              new ProjectFolder(Path.of(".")).configurationText(); // says what is missing
              return Path.of(".");
            });
  }
}
