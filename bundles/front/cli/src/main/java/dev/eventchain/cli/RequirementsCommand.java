package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.requirements.RequirementChanges;
import dev.eventchain.pipeline.requirements.RequirementTable;
import dev.eventchain.project.SuppressionFile;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code requirements}: lists the requirements of a project, or what changed in them. */
@Command(
    name = "requirements",
    mixinStandardHelpOptions = true,
    description = {
      "List the requirements of a project: where each is written, the components that satisfy it, the"
          + " scenarios that test it, and the verdict of the last run.",
      "A verdict about older texts or files counts as not tested. Nothing is run or written.",
      "With --diff, list what changed since an older state, and what names a changed requirement and"
          + " is about its older text. The exit code is then 1 if there is any, unless 'eventchain"
          + " accept' has recorded that somebody looked at it."
    })
final class RequirementsCommand implements Callable<Integer> {

  /** The formats of a list that is none of findings. */
  enum Format {
    TEXT,
    JSON;

    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  @Parameters(index = "0", paramLabel = "DIR", description = "The project's folder.")
  private Path folder;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "FOLDER",
      description = "Where the project's results are (default: DIR/out).")
  private Path output;

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "text",
      description = "The format of the list: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
  private Format format;

  @Option(
      names = "--diff",
      paramLabel = "OLD",
      description =
          "The older state: a folder of the project, its requirements in a file or folder of any"
              + " format, or a folder of results.")
  private Path old;

  private final Console console;

  RequirementsCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() {
    Project project = Project.open(folder);
    Path results = output == null ? project.defaultOutput() : output;
    Suppressions suppressions =
        project
            .suppressions()
            .map(file -> SuppressionFile.read(file, console.today().date()))
            .orElse(Suppressions.NONE);
    if (old == null) {
      RequirementTable table = RequirementTable.of(project, results, suppressions);
      print(format == Format.JSON ? table.json() : table.text(), table.diagnostics(), suppressions);
      return ExitCode.FINE;
    }
    RequirementChanges changes = RequirementChanges.of(project, results, old, suppressions);
    print(
        format == Format.JSON ? changes.json() : changes.text(),
        changes.diagnostics(),
        suppressions);
    return changes.isAnyStale() ? ExitCode.FINDINGS : ExitCode.FINE;
  }

  private void print(String list, List<Diagnostic> found, Suppressions suppressions) {
    console.out().print(list);
    console.out().flush();
    console.err().print(DiagnosticFormat.TEXT.render(suppressions.part(found).remaining()));
    console.err().flush();
  }
}
