package dev.eventchain.cli;

import dev.eventchain.check.ModelValidation;
import dev.eventchain.check.Validation;
import dev.eventchain.cli.console.Console;
import dev.eventchain.cli.options.LlmOptions;
import dev.eventchain.cli.options.MetamodelOptions;
import dev.eventchain.cli.options.ScenarioOptions;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.run.Stages;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
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
      "In a project, everything that 'run DIR' refuses before it simulates is checked: the model,"
          + " requirements, bench, scenarios, faults and components.",
      "Event chains are checked by the standard constraints and message contracts, too.",
      "A chain that people edit (model/chain.xmi) is checked as it is, without a language model; "
          + "design rules without constraints are reported.",
      "In any other project, a missing model and missing generated constraints are created first, as by 'run DIR'."
    },
    synopsisHeading = "Usage:%n",
    customSynopsis = {
      "eventchain validate DIR... [OPTIONS]",
      "eventchain validate MODEL.xmi... [--ocl FILE.ocl] [--messages FOLDER] [OPTIONS]",
      "eventchain validate --metamodel FILE.ecore [--ocl FILE.ocl] MODEL... [OPTIONS]"
    })
final class ValidateCommand extends ProjectCommand {

  @Parameters(
      arity = "1..*",
      paramLabel = "DIR|MODEL",
      description = "The folders of projects, and model files.")
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

  @Option(
      names = "--faults",
      paramLabel = "FILE",
      description =
          "A file of faults to be checked with the project, as of 'run --faults'; DIR/faults.yaml"
              + " is checked anyway.")
  private Path faults;

  @Option(
      names = "--allow-empty",
      description =
          "For model files: that nothing but the shape of a model can be checked, since no"
              + " constraint is about it, is not an error.")
  private boolean allowEmpty;

  @Mixin private LlmOptions llm;

  ValidateCommand(Console console) {
    super(console);
  }

  @Override
  Outcome work() {
    List<Path> projects = inputs.stream().filter(this::isProject).toList();
    List<Path> models = inputs.stream().filter(input -> !projects.contains(input)).toList();
    if (!projects.isEmpty() && (!given.metamodels().isEmpty() || !constraints.isEmpty())) {
      throw wrongUsage(
          projects.get(0)
              + " is a folder: a project is validated by its own constraints.ocl and without"
              + " --metamodel and --ocl");
    }
    if (models.isEmpty() && !messages.isEmpty()) {
      throw wrongUsage("--messages is for model files; a project has software-base/msg");
    }
    if (models.isEmpty() && allowEmpty) {
      throw wrongUsage("--allow-empty is for model files; there is always a rule for a project");
    }
    if (projects.size() != 1 && (faults != null || output() != null)) {
      throw wrongUsage((faults == null ? "-o" : "--faults") + " is for one project");
    }
    if (inputs.size() == 1) {
      return projects.isEmpty() ? validate(models) : validate(Project.open(projects.get(0)));
    }
    List<Supplier<Outcome>> parts = new ArrayList<>();
    projects.forEach(project -> parts.add(() -> validate(Project.open(project))));
    if (!models.isEmpty()) {
      parts.add(() -> validate(models));
    }
    return parts.stream().map(ValidateCommand::guarded).reduce(Outcome::and).orElseThrow();
  }

  /** Returns whether an input is validated as a project; a single one also if it is missing. */
  private boolean isProject(Path input) {
    boolean plain = !given.metamodels().isEmpty() || !constraints.isEmpty();
    return Files.isDirectory(input)
        || (inputs.size() == 1 && !plain && !Files.isRegularFile(input));
  }

  /** Turns a failure into a finding, so that other inputs are checked, too. */
  private static Outcome guarded(Supplier<Outcome> work) {
    try {
      return work.get();
    } catch (RuntimeException | Error e) {
      return Outcome.of(e);
    }
  }

  private Outcome validate(List<Path> models) {
    Suppressions suppressions = suppressions();
    Validation validation =
        ModelValidation.validate(given.of(models), constraints, messages, timeLimit());
    Validation counted = allowEmpty ? validation.withoutNeedOfConstraints() : validation;
    return Outcome.of(counted.coverage(), counted.diagnostics(), suppressions);
  }

  /** Validates a project after the stages that create its model and constraints. */
  private Outcome validate(Project project) {
    boolean ready = project.isReadyToValidate(outputOf(project));
    Stage first = ready ? Stage.VALIDATE : Stage.DESIGN;
    ScenarioOptions scenarios = ScenarioOptions.ofFaults(faults);
    return execute(project, new Stages(first, Stage.VALIDATE, ready), llm, scenarios);
  }
}
