package dev.eventchain.cli;

import dev.eventchain.check.ModelValidation;
import dev.eventchain.check.Validation;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Stage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code validate}: a project's model, or any models of any Ecore metamodel. */
@Command(
    name = "validate",
    mixinStandardHelpOptions = true,
    description = {
      "Check a project's model, event chains, or models of any Ecore metamodel, with OCL.",
      "Models must be instances of their metamodel: multiplicities, opposites, keys, data types.",
      "Files that they refer to are checked, too.",
      "Event chains are checked by the standard constraints and message contracts, too.",
      "A chain that people edit (model/chain.xmi) is checked as it is, without a language model; "
          + "design rules without constraints are reported.",
      "In any other project, a missing model and missing generated constraints are created first, as by 'run DIR'."
    },
    synopsisHeading = "Usage:%n",
    customSynopsis = {
      "eventchain validate DIR [OPTIONS]",
      "eventchain validate MODEL.xmi... [--ocl FILE.ocl] [--messages FOLDER] [OPTIONS]",
      "eventchain validate --metamodel FILE.ecore [--ocl FILE.ocl] MODEL... [OPTIONS]"
    })
final class ValidateCommand extends ProjectCommand {

  @Parameters(
      arity = "1..*",
      paramLabel = "DIR|MODEL",
      description = "The project's folder, or model files.")
  private List<Path> inputs;

  @Mixin private MetamodelOptions given;

  @Option(
      names = "--ocl",
      paramLabel = "FILE",
      description = "A Complete OCL document; may be repeated.")
  private List<Path> constraints = List.of();

  @Option(
      names = "--messages",
      paramLabel = "FOLDER",
      description =
          "A folder with the messages that event chains use, as PACKAGE/msg/NAME.msg or .idl; may be repeated.")
  private List<Path> messages = List.of();

  @Mixin private LlmOptions llm;

  ValidateCommand(Console console) {
    super(console);
  }

  @Override
  Outcome work() {
    boolean files = !given.metamodels.isEmpty() || !constraints.isEmpty() || inputs.size() > 1;
    if (!files && !Files.isRegularFile(inputs.get(0))) {
      if (!messages.isEmpty()) {
        throw wrongUsage("--messages is for model files; a project has software-base/msg");
      }
      return validate(Project.open(inputs.get(0)));
    }
    refuseFolders();
    Suppressions suppressions = suppressions();
    Validation validation =
        ModelValidation.validate(
            given.metamodels, given.map, constraints, inputs, messages, timeLimit());
    return Outcome.of(validation.coverage(), validation.diagnostics(), suppressions);
  }

  /** Rejects folders as models, and explains how a project is validated. */
  private void refuseFolders() {
    for (Path input : inputs) {
      if (Files.isDirectory(input)) {
        throw wrongUsage(
            input
                + " is a folder: a project is validated alone, by its own constraints.ocl and"
                + " without --metamodel and --ocl; models are named one by one");
      }
    }
  }

  /** Validates a project after the stages that create its model and constraints. */
  private Outcome validate(Project project) {
    boolean ready = project.isReadyToValidate(outputOf(project));
    Stage first = ready ? Stage.VALIDATE : Stage.DESIGN;
    return execute(project, first, Stage.VALIDATE, ready, llm, new ScenarioOptions());
  }
}
