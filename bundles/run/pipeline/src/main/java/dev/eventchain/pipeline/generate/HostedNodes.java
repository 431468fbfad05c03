package dev.eventchain.pipeline.generate;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.pipeline.stage.NodeModules;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.HostedNode;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.sandbox.ComponentRules;
import dev.eventchain.simulation.node.NodeManifest;
import java.nio.file.Path;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Nodes of a chain that are hosted as they are: their sources, and their entries in the manifest.
 */
public final class HostedNodes {

  private HostedNodes() {}

  /** Returns the entries of the manifest, with commas between them; empty if there is none. */
  static String entries(RunContext run) {
    return nodes(run)
        .map(component -> entry(component.name(), component.node().orElseThrow()).toString())
        .collect(Collectors.joining(",\n    "));
  }

  private static ObjectNode entry(String name, HostedNode node) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("name", name).put("module", node.module()).put("class", node.className());
    ObjectNode launch = json.putObject("launch");
    launch.put("name", node.name()).put("namespace", node.namespace());
    ObjectNode remappings = launch.putObject("remappings");
    new TreeMap<>(node.remappings()).forEach(remappings::put);
    node.arguments().ifPresent(given -> launch.set("arguments", given));
    node.parameters().ifPresent(given -> launch.set("parameters", given));
    return json;
  }

  /**
   * Returns the Python files below the folders from which the nodes are imported, by the paths of
   * their copies in the folder of the generated package. Of files of one name that no node imports,
   * such as setup.py, one is copied.
   *
   * @throws DiagnosticException FINDINGS ({@code component.import.helper}) if two that nodes import
   *     have the same name, but not the same text
   */
  public static SortedMap<String, Path> copies(RunContext run) {
    SortedMap<String, Path> copies = new TreeMap<>();
    for (SoftwareBase.Component component : nodes(run).toList()) {
      Path root = component.node().orElseThrow().root();
      for (Path file : NodeModules.withNode(component)) {
        if (file.startsWith(root)) {
          Path other = copies.putIfAbsent(copy(root, file), file);
          requireSame(file, other == null ? file : other);
        }
      }
    }
    for (Path root : nodes(run).map(each -> each.node().orElseThrow().root()).distinct().toList()) {
      for (Path file : ProjectFolder.below(root)) {
        if (file.toString().endsWith(".py")) {
          copies.putIfAbsent(copy(root, file), file);
        }
      }
    }
    return copies;
  }

  /** Returns the path of the copy of a file, in the folder of the generated package. */
  public static String copy(Path root, Path file) {
    return NodeManifest.NODES + "/" + root.relativize(file).toString().replace('\\', '/');
  }

  /** Refuses two modules of one name, since nodes of both folders would run the same one. */
  private static void requireSame(Path file, Path other) {
    if (!file.equals(other)
        && !SourceText.read(file).text().equals(SourceText.read(other).text())) {
      throw new DiagnosticException(
          DiagnosticException.Reason.FINDINGS,
          Diagnostic.of(
                  ComponentRules.IMPORT_HELPER,
                  "Another node needs another module of this name: "
                      + SourceLocation.of(other).file()
                      + ".",
                  SourceLocation.of(file))
              .withHint("Rename one of them, or put both into packages of different names."));
    }
  }

  private static Stream<SoftwareBase.Component> nodes(RunContext run) {
    Map<String, SoftwareBase.Component> known = new TreeMap<>();
    run.softwareBase().components().stream()
        .filter(component -> component.node().isPresent())
        .forEach(component -> known.put(component.name(), component));
    return run.chain().chain().getSoftware().stream()
        .filter(node -> known.containsKey(String.valueOf(node.getName())))
        .map(node -> known.get(node.getName()));
  }
}
