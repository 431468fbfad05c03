package dev.eventchain.simulation.node;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What a template set generated for a chain: the module and the class of each node, and the
 * component that it executes. The templates write it next to the package; nothing else knows their
 * rules for names.
 *
 * @param location the file
 * @param packageName the name of the Python package
 * @param nodes in the order of the chain; no name twice
 */
public record NodeManifest(SourceLocation location, String packageName, List<Node> nodes) {

  /** What the file is called, in the folder of the generated package. */
  public static final String FILE = "eventchain-manifest.json";

  /** The id of everything that can be wrong with a manifest. */
  public static final String ID = "simulation.manifest";

  static final String GENERATE_AGAIN =
      "Generate again with a template that writes it as the rule's page describes.";

  /**
   * A node around a component.
   *
   * @param name that of the model
   * @param module the Python module, with its package
   * @param className its class in that module
   */
  public record Node(String name, String module, String className, Component component) {}

  /**
   * What a node executes.
   *
   * @param module the Python module, with its packages
   * @param className its class in that module
   * @param file where that module is, relative to the manifest's folder, with {@code /}
   * @param inputs the keyword arguments of {@code execute()}; none twice
   * @param outputs what it returns; no name twice
   */
  public record Component(
      String module, String className, String file, List<String> inputs, List<Output> outputs) {

    /** Copies the lists. */
    public Component {
      inputs = List.copyOf(inputs);
      outputs = List.copyOf(outputs);
    }
  }

  /**
   * A value that a component returns.
   *
   * @param name its key
   * @param type that of the model, such as {@code float32}; empty if the model states none
   */
  public record Output(String name, String type) {}

  /** Copies the list. */
  public NodeManifest {
    nodes = List.copyOf(nodes);
  }

  /**
   * Reads a manifest strictly: nothing missing, unknown, of another type or there twice, and no
   * path that leads out of its folder.
   *
   * @throws DiagnosticException (INPUT) {@code simulation.manifest}, a finding for each mistake
   */
  public static NodeManifest read(SourceText text) {
    return NodeManifestReader.read(text);
  }

  /**
   * The node of this name.
   *
   * @param name that of the model
   */
  public Optional<Node> find(String name) {
    return nodes.stream().filter(node -> node.name().equals(name)).findFirst();
  }

  /**
   * What keeps the chain from being run as the manifest says.
   *
   * @param folder the folder of the manifest
   * @param components those of the chain that are to be run
   * @return empty if each component has a node, each node is one of the chain, and the files of
   *     their modules are there
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
    }
    for (int i = 0; i < nodes.size(); i++) {
      Node node = nodes.get(i);
      String place = "/nodes/" + i;
      if (chain.getSoftware().stream().noneMatch(known -> node.name().equals(known.getName()))) {
        problems.add(problem("The chain has no component '" + node.name() + "'.", place));
      }
      missingFile(folder, file(node.module()), place + "/module").ifPresent(problems::add);
      missingFile(folder, node.component().file(), place + "/component/file")
          .ifPresent(problems::add);
    }
    return problems;
  }

  /** The finding that a component of the chain has no node. */
  public Diagnostic missing(String component) {
    return problem("It names no node for the component '" + component + "'.", "/nodes");
  }

  /** Where a module is, relative to the folder that Python looks in. */
  static String file(String module) {
    return module.replace('.', '/') + ".py";
  }

  private Optional<Diagnostic> missingFile(Path folder, String file, String place) {
    return Files.isRegularFile(folder.resolve(file))
        ? Optional.empty()
        : Optional.of(problem("There is no file " + file + " next to it.", place));
  }

  private Diagnostic problem(String message, String element) {
    return Diagnostic.error(ID, message, location.withElement(element)).withHint(GENERATE_AGAIN);
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
