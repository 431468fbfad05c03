package dev.eventchain.simulation.node;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.ComponentUnits;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Generated nodes of a chain: the module and the class of each node, and the component that it
 * executes. The templates write it next to the package; no other code knows their naming rules.
 *
 * @param location the file
 * @param packageName the name of the Python package
 * @param nodes in the order of the chain; no name twice
 */
public record NodeManifest(SourceLocation location, String packageName, List<Node> nodes) {

  /** Name of the file in the folder of the generated package. */
  public static final String FILE = "eventchain-manifest.json";

  /** Rule of all findings on manifests. */
  public static final Rule ID = NodeRules.SIMULATION_MANIFEST;

  static final String GENERATE_AGAIN =
      "Generate again with a template that writes it as the rule's page describes.";

  /** Name of the folder in that of the generated package from which nodes as they are come. */
  public static final String NODES = "nodes";

  /**
   * A node around a component, or a node as it is.
   *
   * @param name its name in the model
   * @param module the Python module, with its package
   * @param className its class in that module
   * @param component empty for a node as it is
   * @param launch how a node as it is is launched; the default for others
   */
  public record Node(
      String name, String module, String className, Optional<Component> component, Launch launch) {}

  /**
   * Settings that a launch file gives a node.
   *
   * @param name empty for its own
   * @param namespace empty for its own
   * @param remappings full names of topics by the names that the node uses
   * @param arguments what it is made with, an object by the names of parameters; empty for what the
   *     file of its class says
   * @param parameters values of its parameters of ROS 2, an object by their names; empty for none
   */
  public record Launch(
      String name,
      String namespace,
      Map<String, String> remappings,
      Optional<JsonNode> arguments,
      Optional<JsonNode> parameters) {

    static final Launch NONE = new Launch("", "", Map.of(), Optional.empty(), Optional.empty());

    /** Copies the map. */
    public Launch {
      remappings = Map.copyOf(remappings);
    }
  }

  /**
   * Component that a node executes.
   *
   * @param module the Python module, with its packages
   * @param className its class in that module
   * @param file the file of the module, relative to the manifest's folder, with {@code /}
   * @param inputs the keyword arguments of {@code execute()}; no duplicates
   * @param outputs the returned values; no duplicate names
   * @param conversions the values whose units the node converts
   */
  public record Component(
      String module,
      String className,
      String file,
      List<String> inputs,
      List<Output> outputs,
      Conversions conversions) {

    /** Copies the lists. */
    public Component {
      inputs = List.copyOf(inputs);
      outputs = List.copyOf(outputs);
    }
  }

  /**
   * Values of a component that its node converts between the units of messages and its own.
   *
   * @param inputs the names of inputs
   * @param outputs the names of outputs
   */
  public record Conversions(List<String> inputs, List<String> outputs) {

    static final Conversions NONE = new Conversions(List.of(), List.of());

    /** Copies the lists. */
    public Conversions {
      inputs = List.copyOf(inputs);
      outputs = List.copyOf(outputs);
    }
  }

  /**
   * A value that a component returns.
   *
   * @param name its key
   * @param type its type in the model, such as {@code float32}; empty if the model states none
   */
  public record Output(String name, String type) {}

  /** Copies the list. */
  public NodeManifest {
    nodes = List.copyOf(nodes);
  }

  /**
   * Reads a manifest strictly: no missing, unknown or duplicate keys, no wrong types, and no paths
   * that leave its folder.
   *
   * @throws DiagnosticException (INPUT) {@code simulation.manifest}, a finding for each mistake
   */
  public static NodeManifest read(SourceText text) {
    return NodeManifestReader.read(text);
  }

  /**
   * Returns the node with a name.
   *
   * @param name its name in the model
   */
  public Optional<Node> find(String name) {
    return nodes.stream().filter(node -> node.name().equals(name)).findFirst();
  }

  /**
   * Returns the contradictions between chain and manifest.
   *
   * @param folder the folder of the manifest
   * @param components the components of the chain to run
   * @return empty if each component has a node, each node is one of the chain, and the files of
   *     their modules exist, and the nodes convert the units that they have to
   */
  List<Diagnostic> problems(EventChain chain, Path folder, List<SoftwareNode> components) {
    List<Diagnostic> problems = new ArrayList<>();
    if (nodes.isEmpty()) {
      problems.add(problem("It names no node: there is nothing to simulate.", "/nodes"));
    }
    for (SoftwareNode component : components) {
      if (find(component.getName()).isEmpty()) {
        problems.add(missing(component.getName()));
      }
      problems.addAll(unconverted(component));
    }
    for (int i = 0; i < nodes.size(); i++) {
      Node node = nodes.get(i);
      String place = "/nodes/" + i;
      if (chain.getSoftware().stream().noneMatch(known -> node.name().equals(known.getName()))) {
        problems.add(problem("The chain has no component '" + node.name() + "'.", place));
      }
      String above = node.component().isPresent() ? "" : NODES + "/";
      missingFile(folder, above + file(node.module()), place + "/module").ifPresent(problems::add);
      node.component()
          .flatMap(known -> missingFile(folder, known.file(), place + "/component/file"))
          .ifPresent(problems::add);
    }
    return problems;
  }

  /** Returns the finding that a component of the chain has no node. */
  public Diagnostic missing(String component) {
    return problem("It names no node for the component '" + component + "'.", "/nodes");
  }

  /**
   * Returns a finding for each value of a component that the model has converted by the node around
   * it, but that node does not convert; empty if the manifest has no such node.
   */
  public List<Diagnostic> unconverted(SoftwareNode component) {
    Optional<Conversions> done =
        find(component.getName()).flatMap(Node::component).map(Component::conversions);
    return done.isEmpty()
        ? List.of()
        : Stream.concat(
                unconverted("input", component.getInput(), done.get().inputs()),
                unconverted("output", component.getOutput(), done.get().outputs()))
            .map(value -> unconverted(component, value))
            .toList();
  }

  private static Stream<String> unconverted(String side, List<Data> values, List<String> done) {
    return values.stream()
        .filter(value -> ComponentUnits.isConverted(value) && !done.contains(value.getName()))
        .map(
            value ->
                "the %s '%s' between %s and %s"
                    .formatted(
                        side,
                        value.getName(),
                        ComponentUnits.onTheWire(value),
                        ComponentUnits.of(value)));
  }

  private Diagnostic unconverted(SoftwareNode component, String value) {
    return problem(
            "The node of '%s' does not convert %s.".formatted(component.getName(), value), "/nodes")
        .withHint(
            "Generate again with templates that convert it and say so by"
                + " [chain.manifestFile(true)/], or convert inside the component.");
  }

  /** Returns the file of a module, relative to the folder on the Python path. */
  static String file(String module) {
    return module.replace('.', '/') + ".py";
  }

  private Optional<Diagnostic> missingFile(Path folder, String file, String place) {
    return Files.isRegularFile(folder.resolve(file))
        ? Optional.empty()
        : Optional.of(problem("There is no file " + file + " next to it.", place));
  }

  private Diagnostic problem(String message, String element) {
    return Diagnostic.of(ID, message, location.withElement(element)).withHint(GENERATE_AGAIN);
  }

  /**
   * Refuses a manifest that is not that of a chain.
   *
   * @param folder that of the package
   * @param components those of the chain that are to be run
   * @throws DiagnosticException (INPUT) {@code simulation.manifest}
   */
  public void requireNodesOf(Path folder, EventChain chain, List<SoftwareNode> components) {
    List<Diagnostic> problems = problems(chain, folder, components);
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
  }
}
