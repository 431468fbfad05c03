package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.options.MetamodelOptions;
import dev.eventchain.cli.options.TemplateOptions;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.pipeline.AnyModel;
import dev.eventchain.pipeline.Outcome;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code compile}: checks templates without a model. */
@Command(
    name = "compile",
    mixinStandardHelpOptions = true,
    description = {
      "Check templates (*.mtl) without a model: syntax, names and types, of them and of all that they import.",
      "Nothing is generated. A template that uses other classes than those of event chains needs --metamodel,"
          + " unless they are of UML or of a profile (*.profile.uml) in the folder of the template."
    },
    synopsisHeading = "Usage:%n",
    customSynopsis = "eventchain compile [--metamodel FILE.ecore] TEMPLATE|FOLDER... [OPTIONS]")
final class CompileCommand extends ProjectCommand {

  private static final String ENDING = ".mtl";

  @Parameters(
      arity = "1..*",
      paramLabel = "TEMPLATE|FOLDER",
      description = "Templates, and folders of which all templates are meant.")
  private List<Path> inputs;

  @Mixin private MetamodelOptions given;

  @Mixin private TemplateOptions with;

  CompileCommand(Console console) {
    super(console);
  }

  @Override
  Outcome work() {
    if (namesOutput()) {
      throw wrongUsage("nothing is written: leave out -o and --overwrite");
    }
    List<Path> templates = new ArrayList<>();
    for (Path input : inputs) {
      List<Path> found = Files.isDirectory(input) ? templatesIn(input) : List.of(input);
      if (found.isEmpty()) {
        throw wrongUsage("there is no template (*" + ENDING + ") in " + input);
      }
      templates.addAll(found);
    }
    Coverage coverage = new Coverage(templates.stream().map(Path::toString).toList(), 0, List.of());
    return Outcome.of(
        coverage,
        AnyModel.compile(
            given.metamodels(),
            given.folders(),
            templates.stream()
                .map(
                    each -> new AnyModel.Template(each, with.sources(), with.services(), List.of()))
                .toList()),
        suppressions());
  }

  private static List<Path> templatesIn(Path folder) {
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(file -> file.toString().endsWith(ENDING) && Files.isRegularFile(file))
          .sorted()
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
