package dev.eventchain.cli;

import dev.eventchain.pipeline.AnyModel;
import dev.eventchain.pipeline.Stage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code validate}: a project's model, or any models of any Ecore metamodel. */
@Command(
    name = "validate",
    mixinStandardHelpOptions = true,
    description = "Check a project's model, or any models of any Ecore metamodel, with OCL.",
    synopsisHeading = "Usage:%n",
    customSynopsis = {
      "eventchain validate DIR [OPTIONS]",
      "eventchain validate --metamodel FILE.ecore --ocl FILE.ocl MODEL... [OPTIONS]"
    })
final class ValidateCommand extends ProjectCommand implements Callable<Integer> {

  @Parameters(
      arity = "1..*",
      paramLabel = "DIR|MODEL",
      description = "The project's folder, or model files.")
  private List<Path> inputs;

  @Option(
      names = "--metamodel",
      paramLabel = "FILE",
      description = "An Ecore metamodel of the models; may be repeated.")
  private List<Path> metamodels = List.of();

  @Option(
      names = "--ocl",
      paramLabel = "FILE",
      description = "A Complete OCL document; may be repeated.")
  private List<Path> constraints = List.of();

  @Spec private CommandSpec spec;

  ValidateCommand(Console console) {
    super(console);
  }

  @Override
  public Integer call() {
    if (metamodels.isEmpty() && constraints.isEmpty()) {
      return validateProject();
    }
    if (constraints.isEmpty()) {
      throw new ParameterException(
          spec.commandLine(), "models of a metamodel need constraints: --ocl FILE");
    }
    AnyModel.Validation validation = AnyModel.validate(metamodels, constraints, inputs);
    console().err().println(validation.summary());
    return console().report(validation.diagnostics(), format());
  }

  private int validateProject() {
    if (inputs.size() > 1 || Files.isRegularFile(inputs.get(0))) {
      throw new ParameterException(
          spec.commandLine(),
          "name one project's folder, or model files with --metamodel and --ocl");
    }
    return execute(
        inputs.get(0), Stage.VALIDATE, Stage.VALIDATE, true, new LlmOptions(), List.of());
  }
}
