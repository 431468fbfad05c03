package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.export.ProjectExport;
import dev.eventchain.pipeline.project.Project;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code export}: writes scenarios for the players of OpenSCENARIO. */
@Command(
    name = "export",
    mixinStandardHelpOptions = true,
    description = {
      "Write a project's scenarios as ASAM OpenSCENARIO XML 1.3 (NAME.xosc) on ASAM OpenDRIVE 1.7",
      "roads (NAME.xodr), so that a player of these formats can show them. Everything is where it is",
      "in the simulation, until the software demands something. A scenario with a part that the",
      "formats cannot express is reported with that line, and not written."
    },
    synopsisHeading = "Usage:%n",
    customSynopsis = "eventchain export DIR --to FOLDER [--scenario NAME]... [OPTIONS]")
final class ExportCommand extends ProjectCommand {

  @Parameters(paramLabel = "DIR", description = "The project's folder.")
  private Path folder;

  @Option(
      names = "--to",
      paramLabel = "FOLDER",
      description = "Where to write; the same as -o. Other files in it stay.")
  private Path to;

  @Option(
      names = "--scenario",
      paramLabel = "NAME",
      description = "Write this scenario only; may be repeated.")
  private List<String> scenarios = new ArrayList<>();

  ExportCommand(Console console) {
    super(console);
  }

  @Override
  Outcome work() {
    if ((to == null) == (output() == null) || (to != null && to.toString().isEmpty())) {
      throw wrongUsage("name the folder for the files once: --to FOLDER");
    }
    Project project = Project.open(folder);
    Path target = to == null ? output() : to;
    return Outcome.of(
        ProjectExport.write(project, scenarios, target, onEdit()), suppressions(project));
  }
}
