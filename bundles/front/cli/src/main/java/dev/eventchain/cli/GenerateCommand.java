package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.options.LlmOptions;
import dev.eventchain.cli.options.MetamodelOptions;
import dev.eventchain.cli.options.ScenarioOptions;
import dev.eventchain.cli.options.TemplateOptions;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.pipeline.AnyModel;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.files.WrittenFiles;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.run.Stages;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code generate}: generates a project's package, or text from any model by any template. */
@Command(
    name = "generate",
    mixinStandardHelpOptions = true,
    description =
        "Generate a project's package by its template set, or text from any model by a template.",
    synopsisHeading = "Usage:%n",
    customSynopsis = {
      "eventchain generate DIR [OPTIONS]",
      "eventchain generate --metamodel FILE.ecore --template FILE.mtl MODEL... -o FOLDER"
    },
    footer = {
      "%nBlocks [file ('stdout', ...)] of a template print to standard error. With -o - they print"
          + " to standard output, no folder is written, and findings go to standard error; a block"
          + " that writes a file is then an error."
    })
final class GenerateCommand extends ProjectCommand {

  private static final Path STANDARD_OUTPUT = Path.of("-");

  @Parameters(
      arity = "1..*",
      paramLabel = "DIR|MODEL",
      description = "The project's folder, or model files, which may refer to each other.")
  private List<Path> inputs;

  @Mixin private MetamodelOptions given;

  @Option(
      names = "--template",
      paramLabel = "FILE",
      description =
          "The template's main module; or nodl, for the interface of each node of an event chain in"
              + " NoDL 2.")
  private Path template;

  @Option(
      names = "--trace",
      description =
          "With --template: write trace.json, which names the template lines and model elements"
              + " behind each line. Projects always get one.")
  private boolean trace;

  @Option(
      names = "--lenient",
      description =
          "With --template: undefined values, values that the metamodel forbids or misses, and files"
              + " that another block overwrites are warnings, which helps when migrating from"
              + " Acceleo. The last such block wins.")
  private boolean lenient;

  @Option(
      names = "--refuse",
      paramLabel = "NAME",
      description =
          "With --template: write nothing if a written file, or a folder of one, has this name;"
              + " '*' stands for any characters. For templates of others; may be repeated.")
  private List<String> refused = List.of();

  @Mixin private TemplateOptions with;

  @Option(
      names = "--properties",
      paramLabel = "FILE",
      description =
          "A properties file, which getProperty('key') reads, in the order of these options;"
              + " may be repeated.")
  private List<Path> properties = List.of();

  GenerateCommand(Console console) {
    super(console);
  }

  @Override
  Outcome work() {
    return template == null ? generateProject() : generateText();
  }

  /** Returns whether the output is {@code -}; a folder of this name is {@code ./-}. */
  @Override
  boolean printsResult() {
    return STANDARD_OUTPUT.equals(output());
  }

  private Outcome generateProject() {
    if (printsResult()) {
      throw wrongUsage("a project has many files: -o - is only for templates");
    }
    if (!given.metamodels().isEmpty()) {
      throw wrongUsage("a model of a metamodel needs a template: --template FILE");
    }
    if (lenient) {
      throw wrongUsage("undefined values are errors in a project: --lenient is only for templates");
    }
    if (!refused.isEmpty()) {
      throw wrongUsage("--refuse needs a template: --template FILE");
    }
    if (!with.services().isEmpty() || !with.sources().isEmpty() || !properties.isEmpty()) {
      throw wrongUsage("--services, --source and --properties need a template: --template FILE");
    }
    if (inputs.size() > 1) {
      throw wrongUsage("name one project, or a template for several models: --template FILE");
    }
    return execute(
        Project.open(inputs.get(0)),
        Stages.only(Stage.GENERATE),
        new LlmOptions(),
        new ScenarioOptions());
  }

  private Outcome generateText() {
    if (output() == null) {
      throw wrongUsage("name the output folder: -o FOLDER");
    }
    if (trace && printsResult()) {
      throw wrongUsage("trace.json needs a folder: -o FOLDER");
    }
    Suppressions suppressions = suppressions();
    WrittenFiles files =
        AnyModel.generate(
            given.of(inputs),
            new AnyModel.Template(template, with.sources(), with.services(), properties),
            new AnyModel.Target(
                printsResult() ? Optional.empty() : Optional.of(output()),
                onEdit(),
                trace,
                Optional.empty(),
                refused),
            new AnyModel.Check(lenient, suppressions, timeLimit()));
    print(files.printed());
    return Outcome.of(files, suppressions);
  }
}
