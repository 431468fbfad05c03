package dev.eventchain.cli;

import dev.eventchain.check.ModelFiles;
import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.options.LlmOptions;
import dev.eventchain.cli.options.MetamodelOptions;
import dev.eventchain.cli.options.ScenarioOptions;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.diagram.Diagrams;
import dev.eventchain.pipeline.diagram.Diagrams.Kind;
import dev.eventchain.pipeline.files.WrittenFiles;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.run.Stages;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code diagram}: draws a project's event chain, or any model or metamodel. */
@Command(
    name = "diagram",
    mixinStandardHelpOptions = true,
    description = {
      "Draw a project's event chain, or any model or Ecore metamodel, as PlantUML text and as SVG.",
      "activity: the components of an event chain, with the topics between them;",
      "instance: a model's elements with their attributes and references;",
      "metamodel: a metamodel's classes. Needs no other program and no network.",
      "If a project has no model yet, it is created first, as by 'run DIR --to model'."
    },
    synopsisHeading = "Usage:%n",
    customSynopsis = {
      "eventchain diagram DIR [--kind KIND] [-o FOLDER] [OPTIONS]",
      "eventchain diagram --metamodel FILE.ecore MODEL -o FOLDER [--kind KIND] [OPTIONS]",
      "eventchain diagram FILE.ecore -o FOLDER [OPTIONS]"
    })
final class DiagramCommand extends ProjectCommand {

  @Parameters(
      paramLabel = "DIR|MODEL",
      description = "The project's folder, a model file, or a metamodel (*.ecore).")
  private Path input;

  @Mixin private MetamodelOptions given;

  @Option(
      names = "--kind",
      paramLabel = "KIND",
      description =
          "What to draw: ${COMPLETION-CANDIDATES} (default: all of a project; instance of a model; "
              + "metamodel of a metamodel); may be repeated.")
  private Set<Kind> kinds = new TreeSet<>();

  DiagramCommand(Console console) {
    super(console);
  }

  @Override
  Outcome work() {
    boolean meansProject = output() == null && !Files.exists(input);
    if (given.metamodels().isEmpty() && (Files.isDirectory(input) || meansProject)) {
      return drawProject(Project.open(input));
    }
    if (output() == null) {
      throw wrongUsage("name the output folder: -o FOLDER");
    }
    boolean isMetamodel = given.metamodels().isEmpty() && input.toString().endsWith(".ecore");
    Set<Kind> wanted = kindsOr(isMetamodel ? Kind.METAMODEL : Kind.INSTANCE);
    if (!given.metamodels().isEmpty() && wanted.contains(Kind.ACTIVITY)) {
      throw wrongUsage("only event chains have an activity diagram: leave out --metamodel");
    }
    boolean classes = isMetamodel && wanted.contains(Kind.METAMODEL);
    List<Path> ecores = classes ? List.of(input) : given.metamodels();
    List<Path> models = classes && wanted.size() == 1 ? List.of() : List.of(input);
    ModelFiles files = new ModelFiles(models, ecores, given.folders());
    return drawn(Diagrams.draw(wanted, files, output(), onEdit()));
  }

  private Outcome drawProject(Project project) {
    Path folder = output() == null ? project.defaultOutput().resolve("diagrams") : output();
    Path results = project.defaultOutput();
    if (project.model(results).isEmpty()) {
      Outcome made = makeModel(project, results);
      if (made.exitCode() != ExitCode.FINE) {
        return made;
      }
    }
    Path model = project.model(results).orElseThrow();
    Set<Kind> wanted = kindsOr(Kind.values());
    ModelFiles files = ModelFiles.of(List.of(model), List.of());
    return drawn(Diagrams.draw(wanted, files, folder, onEdit()));
  }

  private Outcome makeModel(Project project, Path results) {
    return execute(
        project, results, Stages.upTo(Stage.MODEL), new LlmOptions(), new ScenarioOptions());
  }

  private Set<Kind> kindsOr(Kind... otherwise) {
    return kinds.isEmpty() ? EnumSet.copyOf(List.of(otherwise)) : kinds;
  }

  private Outcome drawn(WrittenFiles files) {
    return Outcome.of(files, suppressions());
  }
}
