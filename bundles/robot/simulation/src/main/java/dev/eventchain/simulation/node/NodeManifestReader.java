package dev.eventchain.simulation.node;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.node.NodeManifest.Component;
import dev.eventchain.simulation.node.NodeManifest.Node;
import dev.eventchain.simulation.node.NodeManifest.Output;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntFunction;

/** Reads a {@link NodeManifest}; collects problems and continues with a neutral value. */
final class NodeManifestReader {

  private static final DocumentRules RULES = DocumentRules.all(NodeManifest.ID);
  private static final int FORMAT = 1;
  private static final String IDENTIFIER = "[A-Za-z_][A-Za-z0-9_]*";
  private static final String MODULE = IDENTIFIER + "(\\." + IDENTIFIER + ")+";

  private final List<Diagnostic> problems = new ArrayList<>();
  private String packageName = "";

  private NodeManifestReader() {}

  static NodeManifest read(SourceText text) {
    NodeManifestReader reader = new NodeManifestReader();
    List<Node> nodes = reader.nodes(text);
    if (!reader.problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, reader.problems);
    }
    return new NodeManifest(SourceLocation.of(text.name()), reader.packageName, nodes);
  }

  /** Adds a problem, without hints at single keys, since the file is generated. */
  private void add(Diagnostic problem) {
    problems.add(problem.withHint(NodeManifest.GENERATE_AGAIN));
  }

  private List<Node> nodes(SourceText text) {
    try {
      return Document.parseWithAnyText(text, DocumentFormat.JSON, RULES, this::add)
          .object("", this::add)
          .map(this::manifest)
          .orElse(List.of());
    } catch (DiagnosticException e) {
      e.diagnostics().forEach(this::add);
      return List.of();
    }
  }

  private List<Node> manifest(ObjectReader json) {
    if (json.value("format").filter(v -> v.isInt() && v.intValue() == FORMAT).isEmpty()) {
      problem(json, "format", "The format has to be " + FORMAT + ".");
      return List.of();
    }
    packageName = name(json, "package", IDENTIFIER, "the name of a package");
    List<ObjectReader> items = json.requiredObjects("nodes");
    List<Node> nodes = items.stream().map(this::node).toList();
    json.refuseOthers();
    unique("node", nodes.stream().map(Node::name).toList(), i -> items.get(i).at("name"));
    // Nodes as they are may be in one module.
    unique(
        "module",
        nodes.stream().map(node -> node.component().isEmpty() ? "" : node.module()).toList(),
        i -> items.get(i).at("module"));
    return nodes;
  }

  private Node node(ObjectReader json) {
    String name = json.requiredText("name");
    String className = name(json, "class", IDENTIFIER, "the name of a class");
    Optional<ObjectReader> launch = json.object("launch");
    Node node =
        launch.isPresent()
            ? new Node(name, plainModule(json), className, Optional.empty(), launch(launch.get()))
            : new Node(
                name,
                module(json),
                className,
                json.requiredObject("component").map(this::component),
                NodeManifest.Launch.NONE);
    json.refuseOthers();
    return node;
  }

  private NodeManifest.Launch launch(ObjectReader json) {
    Map<String, String> remappings = new LinkedHashMap<>();
    json.requiredObject("remappings")
        .ifPresent(
            pairs -> pairs.names().forEach(from -> remappings.put(from, pairs.requiredText(from))));
    requireKey(json, "name");
    requireKey(json, "namespace");
    NodeManifest.Launch launch =
        new NodeManifest.Launch(
            json.text("name").orElse(""),
            json.text("namespace").orElse(""),
            remappings,
            json.object("arguments").flatMap(given -> json.value("arguments")),
            json.object("parameters").flatMap(given -> json.value("parameters")));
    json.refuseOthers();
    return launch;
  }

  private String plainModule(ObjectReader json) {
    return name(json, "module", IDENTIFIER + "(\\." + IDENTIFIER + ")*", "a module");
  }

  private Component component(ObjectReader json) {
    List<ObjectReader> items = json.requiredObjects("outputs");
    List<Output> outputs = items.stream().map(this::output).toList();
    unique("output", outputs.stream().map(Output::name).toList(), i -> items.get(i).at("name"));
    String module = module(json);
    String file = json.requiredText("file");
    String expected = NodeManifest.file(module);
    if (!file.isEmpty() && !module.isEmpty() && !file.equals(expected)) {
      problem(json, "file", "The file of the module " + module + " has to be " + expected + ".");
    }
    String name = name(json, "class", IDENTIFIER, "the name of a class");
    List<String> inputs = inputs(json);
    NodeManifest.Conversions conversions =
        json.object("conversions").map(this::conversions).orElse(NodeManifest.Conversions.NONE);
    json.refuseOthers();
    return new Component(module, name, file, inputs, outputs, conversions);
  }

  private List<String> inputs(ObjectReader json) {
    requireKey(json, "inputs");
    List<String> inputs = json.texts("inputs");
    for (String input : inputs) {
      if (!input.matches(IDENTIFIER)) {
        problem(json, "inputs", "'" + input + "' is not the name of an argument.");
      }
    }
    unique("input", inputs, i -> json.at("inputs"));
    return inputs;
  }

  private NodeManifest.Conversions conversions(ObjectReader json) {
    requireKey(json, "inputs");
    requireKey(json, "outputs");
    NodeManifest.Conversions conversions =
        new NodeManifest.Conversions(json.texts("inputs"), json.texts("outputs"));
    json.refuseOthers();
    return conversions;
  }

  private Output output(ObjectReader json) {
    String name = name(json, "name", IDENTIFIER, "a name");
    requireKey(json, "type");
    Output output = new Output(name, json.text("type").orElse(""));
    json.refuseOthers();
    return output;
  }

  private String module(ObjectReader json) {
    String module = name(json, "module", MODULE, "a module in a package");
    if (!packageName.isEmpty() && !module.isEmpty() && !module.startsWith(packageName + ".")) {
      String message = "The module " + module + " is not in the package " + packageName + ".";
      problem(json, "module", message);
    }
    return module;
  }

  private String name(ObjectReader json, String key, String pattern, String expected) {
    String value = json.requiredText(key);
    if (value.isEmpty() || value.matches(pattern)) {
      return value;
    }
    problem(json, key, "'" + value + "' is not " + expected + ".");
    return "";
  }

  /** Requires a key, whose value may be empty. */
  private void requireKey(ObjectReader json, String key) {
    if (json.value(key).isEmpty()) {
      problem(json, key, "'" + key + "' is missing.");
    }
  }

  private void unique(String what, List<String> names, IntFunction<SourceLocation> places) {
    Set<String> seen = new HashSet<>();
    for (int i = 0; i < names.size(); i++) {
      String name = names.get(i);
      if (!name.isEmpty() && !seen.add(name)) {
        String message = "The " + what + " '" + name + "' is declared twice.";
        add(Diagnostic.of(NodeManifest.ID, message, places.apply(i)));
      }
    }
  }

  private void problem(ObjectReader json, String key, String message) {
    json.find(NodeManifest.ID, message, json.at(key));
  }
}
