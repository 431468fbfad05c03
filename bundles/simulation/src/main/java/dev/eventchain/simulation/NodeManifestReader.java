package dev.eventchain.simulation;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.NodeManifest.Component;
import dev.eventchain.simulation.NodeManifest.Node;
import dev.eventchain.simulation.NodeManifest.Output;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Set;
import java.util.function.Function;

/**
 * Reads a {@link NodeManifest}; problems are collected, and reading goes on with a neutral value.
 */
final class NodeManifestReader {

  private static final int FORMAT = 1;
  private static final String IDENTIFIER = "[A-Za-z_][A-Za-z0-9_]*";
  private static final String MODULE = IDENTIFIER + "(\\." + IDENTIFIER + ")+";

  private static final String ANYTHING = "(?s).*";

  private static final JsonMapper MAPPER =
      JsonMapper.builder(
              JsonFactory.builder().enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).build())
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .build();

  private final SourceText text;
  private final List<Diagnostic> problems = new ArrayList<>();

  private NodeManifestReader(SourceText text) {
    this.text = text;
  }

  static NodeManifest read(SourceText text) {
    NodeManifestReader reader = new NodeManifestReader(text);
    NodeManifest manifest = reader.manifest(reader.parse());
    if (!reader.problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, reader.problems);
    }
    return manifest;
  }

  private JsonNode parse() {
    try {
      return MAPPER.readTree(text.text());
    } catch (JsonProcessingException e) {
      var place = e.getLocation();
      SourceLocation location =
          place == null ? text.at(0) : text.at(place.getLineNr(), place.getColumnNr());
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.error(NodeManifest.ID, "This is not JSON.", location)
              .withHint(NodeManifest.GENERATE_AGAIN));
    }
  }

  private NodeManifest manifest(JsonNode json) {
    JsonNode format = json.path("format");
    if (!json.isObject()) {
      problem("An object is expected here.", "");
      return new NodeManifest(SourceLocation.of(text.name()), "", List.of());
    }
    if (!(format.isInt() && format.intValue() == FORMAT)) {
      problem("The format has to be " + FORMAT + ".", "/format");
      return new NodeManifest(SourceLocation.of(text.name()), "", List.of());
    }
    keys(json, "", "format", "package", "nodes");
    String name = text(json, "", "package", IDENTIFIER, "the name of a package");
    List<Node> nodes = items(json, "", "nodes", this::node);
    unique(nodes.stream().map(Node::name).toList(), "/nodes", "node");
    unique(nodes.stream().map(Node::module).toList(), "/nodes", "module");
    for (int i = 0; i < nodes.size(); i++) {
      inPackage(name, nodes.get(i).module(), "/nodes/" + i + "/module");
      inPackage(name, nodes.get(i).component().module(), "/nodes/" + i + "/component/module");
    }
    return new NodeManifest(SourceLocation.of(text.name()), name, nodes);
  }

  private Node node(Item item) {
    JsonNode json = item.json();
    String at = item.pointer();
    keys(json, at, "name", "module", "class", "component");
    return new Node(
        text(json, at, "name", ANYTHING, "a text"),
        text(json, at, "module", MODULE, "a module in a package"),
        text(json, at, "class", IDENTIFIER, "the name of a class"),
        component(json.path("component"), at + "/component"));
  }

  private Component component(JsonNode json, String at) {
    keys(json, at, "module", "class", "file", "inputs", "outputs");
    List<String> inputs =
        items(json, at, "inputs", item -> value(item, IDENTIFIER, "the name of an argument"));
    unique(inputs, at + "/inputs", "input");
    List<Output> outputs = items(json, at, "outputs", this::output);
    unique(outputs.stream().map(Output::name).toList(), at + "/outputs", "output");
    String module = text(json, at, "module", MODULE, "a module in a package");
    String file = text(json, at, "file", ANYTHING, "a text");
    if (json.has("file") && !module.isEmpty() && !file.equals(NodeManifest.file(module))) {
      String expected = NodeManifest.file(module);
      problem("The file of the module " + module + " has to be " + expected + ".", at + "/file");
    }
    String name = text(json, at, "class", IDENTIFIER, "the name of a class");
    return new Component(module, name, file, inputs, outputs);
  }

  private void inPackage(String name, String module, String at) {
    if (!name.isEmpty() && !module.isEmpty() && !module.startsWith(name + ".")) {
      problem("The module " + module + " is not in the package " + name + ".", at);
    }
  }

  private Output output(Item item) {
    keys(item.json(), item.pointer(), "name", "type");
    return new Output(
        text(item.json(), item.pointer(), "name", IDENTIFIER, "a name"),
        text(item.json(), item.pointer(), "type", ANYTHING, "a text"));
  }

  /** A value of a list. */
  private record Item(JsonNode json, String pointer) {}

  private <T> List<T> items(JsonNode json, String at, String key, Function<Item, T> read) {
    List<T> items = new ArrayList<>();
    JsonNode list = json.path(key);
    if (!list.isArray() && json.isObject() && json.has(key)) {
      problem("A list is expected here.", at + "/" + key);
    }
    for (int i = 0; list.isArray() && i < list.size(); i++) {
      items.add(read.apply(new Item(list.get(i), at + "/" + key + "/" + i)));
    }
    return items;
  }

  private String text(JsonNode json, String at, String key, String pattern, String expected) {
    return json.has(key)
        ? value(new Item(json.get(key), at + "/" + key), pattern, expected)
        : ""; // keys() has said so
  }

  private String value(Item item, String pattern, String expected) {
    if (item.json().isTextual() && item.json().textValue().matches(pattern)) {
      return item.json().textValue();
    }
    problem(item.json() + " is not " + expected + ".", item.pointer());
    return "";
  }

  /** Reports what is no object, and keys that are missing or unknown. */
  private void keys(JsonNode json, String at, String... known) {
    if (!json.isObject()) {
      if (!json.isMissingNode()) { // what is missing was reported where it should be
        problem("An object is expected here.", at);
      }
      return;
    }
    Set<String> present = new HashSet<>();
    for (Iterator<String> names = json.fieldNames(); names.hasNext(); ) {
      String name = names.next();
      present.add(name);
      if (!List.of(known).contains(name)) {
        problem("There is no key '" + name + "' here.", at + "/" + name);
      }
    }
    for (String key : known) {
      if (!present.contains(key)) {
        problem("The key '" + key + "' is missing.", at);
      }
    }
  }

  private void unique(List<String> names, String at, String what) {
    Set<String> seen = new HashSet<>();
    for (int i = 0; i < names.size(); i++) {
      if (!names.get(i).isEmpty() && !seen.add(names.get(i))) {
        problem("The " + what + " '" + names.get(i) + "' is there twice.", at + "/" + i);
      }
    }
  }

  private void problem(String message, String pointer) {
    problems.add(
        Diagnostic.error(
                NodeManifest.ID, message, SourceLocation.of(text.name()).withElement(pointer))
            .withHint(NodeManifest.GENERATE_AGAIN));
  }
}
