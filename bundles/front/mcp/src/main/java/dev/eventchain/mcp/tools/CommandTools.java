package dev.eventchain.mcp.tools;

import dev.eventchain.mcp.project.Boundary;
import dev.eventchain.mcp.project.Protection;
import dev.eventchain.mcp.tools.Parameter.ArgumentType;
import dev.eventchain.mcp.tools.Tool.Call;
import dev.eventchain.mcp.tools.Tool.Effect;
import dev.eventchain.mcp.tools.Tool.Result;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The tools that are commands. */
final class CommandTools {

  /** The project that a tool is about. */
  static final Parameter PROJECT =
      Parameter.of(
          "project",
          ArgumentType.TEXT,
          "The project's folder below the server's. Default: the server's own.");

  private static final Parameter SCENARIOS =
      Parameter.of(
          "scenarios",
          ArgumentType.TEXTS,
          "Names of the scenarios to be simulated, without .yaml. Default: all. With a choice the"
              + " verdict is about less, and INCOMPLETE at best.");

  private final Commands commands;
  private final Boundary boundary;

  CommandTools(Commands commands, Boundary boundary) {
    this.commands = commands;
    this.boundary = boundary;
  }

  /** Returns the tools. */
  List<Tool> all() {
    return List.of(
        init(),
        validate(),
        explain(),
        generate(),
        simulate(),
        suites(),
        run(),
        campaign(),
        search(),
        mutate());
  }

  private Tool init() {
    return new Tool(
        "init",
        "Start a project",
        "Creates a project in a new or empty folder: a small example that runs as it is, or, with"
            + " 'workspace', one around the nodes of a ROS 2 workspace. Existing files stay.",
        Effect.ADDS,
        List.of(
            PROJECT,
            Parameter.of(
                "workspace", ArgumentType.TEXT, "A colcon workspace inside the server's folder.")),
        Commands.plainOutput(),
        (arguments, call) -> {
          Protection.requireStartable(boundary, boundary.inside(projectOf(arguments)));
          List<String> command = command("init", arguments);
          arguments
              .text("workspace")
              .ifPresent(name -> command.add("--from-workspace=" + closed(name)));
          return commands.print(command, call);
        });
  }

  private Tool validate() {
    return new Tool(
        "validate",
        "Check a project or models",
        "Checks everything of a project that can be checked without simulation: model,"
            + " constraints, requirements, bench, scenarios, faults, components. With 'models',"
            + " checks these models of any Ecore metamodel instead.",
        Effect.ADDS,
        List.of(
            PROJECT,
            Parameter.of("models", ArgumentType.TEXTS, "Model files, instead of a project."),
            Parameter.of("metamodels", ArgumentType.TEXTS, "The .ecore files of the models."),
            Parameter.of("ocl", ArgumentType.TEXTS, "Complete OCL documents for the models.")),
        Commands.OUTPUT,
        this::validated);
  }

  private Result validated(Arguments arguments, Call call) {
    List<String> models = arguments.texts("models");
    List<String> command;
    if (models.isEmpty()) {
      command = command("validate", arguments);
    } else {
      requireNoProject(arguments);
      command = new ArrayList<>(List.of("validate"));
      models.forEach(model -> command.add(closed(model)));
    }
    arguments.texts("metamodels").forEach(file -> command.add("--metamodel=" + closed(file)));
    arguments.texts("ocl").forEach(file -> command.add("--ocl=" + closed(file)));
    return commands.report(command, call);
  }

  private Tool explain() {
    return new Tool(
        "explain",
        "Explain a finding",
        "Explains a finding by the id in brackets behind it, such as ocl.violated, or a standard"
            + " constraint. Without an id, lists all; the resource eventchain://rules has the whole"
            + " list.",
        Effect.READS,
        List.of(Parameter.of("id", ArgumentType.TEXT, "The id. Default: all ids are listed.")),
        Commands.plainOutput(),
        (arguments, call) -> {
          List<String> command = new ArrayList<>(List.of("explain"));
          arguments.text("id").ifPresent(id -> command.addAll(List.of("--", plain(id))));
          return commands.print(command, call);
        });
  }

  private Tool generate() {
    return new Tool(
        "generate",
        "Generate code",
        "Generates a project's ROS 2 package. With 'template' and 'models', generates text from"
            + " models of any metamodel by an Acceleo 3 template, into 'output'.",
        Effect.ADDS,
        List.of(
            PROJECT,
            Parameter.of("template", ArgumentType.TEXT, "The main module of a template (.mtl)."),
            Parameter.of("models", ArgumentType.TEXTS, "The models for the template."),
            Parameter.of("metamodels", ArgumentType.TEXTS, "The .ecore files of the models."),
            Parameter.of(
                "output",
                ArgumentType.TEXT,
                "The folder that a template writes into: outside of projects, or in the 'out' of"
                    + " one.")),
        Commands.OUTPUT,
        this::generated);
  }

  private Result generated(Arguments arguments, Call call) {
    if (arguments.text("template").isEmpty()) {
      return commands.report(command("generate", arguments), call);
    }
    requireNoProject(arguments);
    List<String> command = new ArrayList<>(List.of("generate"));
    arguments.texts("models").forEach(model -> command.add(closed(model)));
    arguments.text("template").ifPresent(file -> command.add("--template=" + closed(file)));
    arguments.texts("metamodels").forEach(file -> command.add("--metamodel=" + closed(file)));
    String output =
        arguments
            .text("output")
            .orElseThrow(
                () ->
                    Arguments.wrong(
                        "The argument 'output' is missing.",
                        "A template writes into a folder that you name."));
    Protection.requireOutput(boundary, boundary.inside(output));
    command.add("--output=" + closed(output));
    Protection.notGenerated().forEach(name -> command.add("--refuse=" + name));
    return commands.report(command, call);
  }

  private Tool simulate() {
    return new Tool(
        "simulate",
        "Simulate the generated nodes",
        "Simulates scenarios of a project whose nodes were generated, in the closed loop, and comes"
            + " to a verdict. After a change of the model or a component, use 'run'.",
        Effect.ADDS,
        List.of(
            PROJECT,
            SCENARIOS,
            Parameter.of(
                "suite",
                ArgumentType.TEXT,
                "Instead of the project's scenarios, a suite by its name, or a campaign file about"
                    + " scenarios of its own. The tool 'suites' lists them."),
            Parameter.oneOf(
                "driver",
                "How nodes run: all in one process (default), or each in its own, over DDS.",
                List.of("lockstep", "dds"))),
        Commands.OUTPUT,
        (arguments, call) -> {
          List<String> command = withScenarios("simulate", arguments);
          arguments.text("suite").ifPresent(name -> command.add("--suite=" + suite(name)));
          arguments.text("driver").ifPresent(driver -> command.add("--driver=" + driver));
          return commands.report(command, call);
        });
  }

  private Tool suites() {
    Map<String, Object> output = new LinkedHashMap<>(Commands.plainOutput());
    output.put("suites", Map.of("type", "array"));
    return new Tool(
        "suites",
        "List suites",
        "Lists the suites for 'simulate': the protocol that each is after, and its cases.",
        Effect.READS,
        List.of(),
        output,
        (arguments, call) -> commands.list(List.of("suites"), call));
  }

  /** Returns a suite as an argument: its name, or a file inside that no link leads out of. */
  private String suite(String name) {
    return name.matches("[a-z0-9-]+") && !Files.exists(boundary.inside(name)) ? name : closed(name);
  }

  private Tool run() {
    return new Tool(
        "run",
        "Run a project to its verdict",
        "Does all that is needed for a verdict and has changed since the last run: design,"
            + " components and their tests, constraints, generation, simulation, report. The"
            + " verdict is PASSED, FAILED, or INCOMPLETE if not all was tested.",
        Effect.ADDS,
        List.of(PROJECT, SCENARIOS),
        Commands.OUTPUT,
        (arguments, call) -> commands.report(withScenarios("run", arguments), call));
  }

  private Tool campaign() {
    return new Tool(
        "campaign",
        "Simulate many cases",
        "Simulates the cases of a campaign file: a scenario with numbers that differ. Results are"
            + " the tables campaigns/NAME/cases.",
        Effect.ADDS,
        List.of(
            PROJECT,
            Parameter.required(
                "file", ArgumentType.TEXT, "The campaign file, relative to the server's folder."),
            Parameter.of(
                "dryRun", ArgumentType.FLAG, "Only count the cases, and say how long they take."),
            Parameter.of(
                "case", ArgumentType.WHOLE, "Simulate and record this case of the table again.")),
        Commands.OUTPUT,
        (arguments, call) -> {
          List<String> command = command("campaign", arguments);
          command.add(closed(arguments.text("file", "")));
          arguments.whole("case").ifPresent(number -> command.add("--case=" + number));
          if (arguments.flag("dryRun")) {
            command.add("--dry-run");
          }
          return commands.report(command, call);
        });
  }

  private Tool search() {
    return new Tool(
        "search",
        "Search for failures",
        "Searches for cases of a campaign file that fail, by minimising margins. Takes minutes to"
            + " hours. That nothing was found proves nothing.",
        Effect.ADDS,
        List.of(
            PROJECT,
            Parameter.required(
                "file", ArgumentType.TEXT, "The campaign file, relative to the server's folder."),
            Parameter.of("only", ArgumentType.TEXT, "Of several campaigns, the one of this name.")),
        Commands.OUTPUT,
        (arguments, call) -> {
          List<String> command = command("search", arguments);
          command.add(closed(arguments.text("file", "")));
          arguments.text("only").ifPresent(name -> command.add("--only=" + name));
          return commands.report(command, call);
        });
  }

  private Tool mutate() {
    return new Tool(
        "mutate",
        "Try small defects",
        "Tries which small defects of components no test and no scenario notices. Takes minutes to"
            + " hours. Results are the table mutants.",
        Effect.ADDS,
        List.of(
            PROJECT,
            Parameter.of("components", ArgumentType.TEXTS, "Mutate these components only.")),
        Commands.OUTPUT,
        (arguments, call) -> {
          List<String> command = command("mutate", arguments);
          arguments.texts("components").forEach(name -> command.add("--component=" + name));
          return commands.report(command, call);
        });
  }

  private List<String> withScenarios(String name, Arguments arguments) {
    List<String> command = command(name, arguments);
    arguments.texts("scenarios").forEach(scenario -> command.add("--scenario=" + scenario));
    return command;
  }

  /** Returns a command about the project of a call. */
  private List<String> command(String name, Arguments arguments) {
    return new ArrayList<>(List.of(name, closed(projectOf(arguments))));
  }

  private static String projectOf(Arguments arguments) {
    return arguments.text("project", ".");
  }

  private String closed(String name) {
    return boundary.closed(name);
  }

  private static void requireNoProject(Arguments arguments) {
    if (arguments.text("project").isPresent()) {
      throw Arguments.wrong(
          "Give either a project or model files.", "Leave 'project' out for model files.");
    }
  }

  /** Returns a text that is no file of arguments. */
  private static String plain(String text) {
    return text.startsWith("@") ? " " + text : text;
  }
}
