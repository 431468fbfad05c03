package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.yaml.snakeyaml.error.Mark;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;
import org.yaml.snakeyaml.nodes.Tag;

/**
 * One mapping of a YAML document, read key by key. Problems are collected, and reading goes on with
 * a neutral value; what nobody asked for is reported by {@link #finish}.
 */
final class YamlSection {

  private final SourceText text;
  private final List<Diagnostic> problems;
  private final Node node;
  private final String pointer;
  private final Map<String, NodeTuple> entries = new LinkedHashMap<>();
  private final List<String> known = new ArrayList<>();

  YamlSection(SourceText text, Node node, String pointer, List<Diagnostic> problems) {
    this.text = text;
    this.node = node;
    this.pointer = pointer;
    this.problems = problems;
    if (node instanceof MappingNode mapping) {
      mapping.getValue().forEach(this::enter);
    } else {
      problem("scenario.value.type", "A mapping with keys is expected here.", node, pointer);
    }
  }

  private void enter(NodeTuple entry) {
    if (!(entry.getKeyNode() instanceof ScalarNode key)) {
      problem("scenario.value.type", "A key must be plain text.", entry.getKeyNode(), pointer);
    } else if (entries.putIfAbsent(key.getValue(), entry) != null) {
      String message = "The key " + key.getValue() + " stands here a second time.";
      problem("scenario.key.duplicate", message, key, pointer(key.getValue()));
    }
  }

  SourceLocation location() {
    return locate(node, pointer);
  }

  /** Where the key stands. */
  SourceLocation location(String key) {
    return locate(entries.get(key).getKeyNode(), pointer(key));
  }

  /** The keys that are present, in the order of the file. */
  List<String> keys() {
    return List.copyOf(entries.keySet());
  }

  boolean has(String key) {
    known.add(key);
    return entries.containsKey(key);
  }

  private Optional<Node> value(String key) {
    return has(key) ? Optional.of(entries.get(key).getValueNode()) : Optional.empty();
  }

  private Optional<Node> required(String key) {
    Optional<Node> value = value(key);
    if (value.isEmpty() && node instanceof MappingNode) {
      problem("scenario.key.missing", "The key " + key + " is missing.", node, pointer);
    }
    return value;
  }

  String requiredText(String key) {
    return required(key).map(value -> text(value, pointer(key))).orElse("");
  }

  String text(String key, String absent) {
    return value(key).map(value -> text(value, pointer(key))).orElse(absent);
  }

  List<String> texts(String key) {
    List<String> texts = new ArrayList<>();
    List<Node> items = items(key);
    for (int i = 0; i < items.size(); i++) {
      texts.add(text(items.get(i), pointer(key) + "/" + i));
    }
    return texts;
  }

  private String text(Node value, String at) {
    if (value instanceof ScalarNode scalar && !scalar.getTag().equals(Tag.NULL)) {
      return scalar.getValue();
    }
    problem("scenario.value.type", "A text is expected here.", value, at);
    return "";
  }

  double requiredNumber(String key, double minimum, double maximum) {
    return required(key).map(value -> number(value, key, minimum, maximum)).orElse(minimum);
  }

  double number(String key, double absent, double minimum, double maximum) {
    return value(key).map(value -> number(value, key, minimum, maximum)).orElse(absent);
  }

  private double number(Node value, String key, double minimum, double maximum) {
    if (!(value instanceof ScalarNode scalar) || !isNumber(scalar)) {
      problem("scenario.value.type", "A number is expected here.", value, pointer(key));
      return minimum;
    }
    double number = Double.parseDouble(scalar.getValue());
    if (number < minimum || number > maximum) {
      String message =
          String.format(
              "%s is %s, but must be from %s to %s.",
              key, scalar.getValue(), plain(minimum), plain(maximum));
      problem("scenario.value.range", message, value, pointer(key));
    }
    return number;
  }

  private static boolean isNumber(ScalarNode scalar) {
    return scalar.isPlain()
        && scalar.getValue().matches("[-+]?[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?");
  }

  private static String plain(double number) {
    return number == StrictMath.rint(number) ? String.valueOf((long) number) : "" + number;
  }

  /** A criterion that is either asked for or left out. */
  void requireTrue(String key) {
    Node value = value(key).orElseThrow();
    if (!(value instanceof ScalarNode scalar) || !scalar.getValue().equals("true")) {
      String message = "Only true is possible here; leave the key out otherwise.";
      problem("scenario.value.type", message, value, pointer(key));
    }
  }

  Optional<YamlSection> section(String key) {
    return value(key).map(value -> new YamlSection(text, value, pointer(key), problems));
  }

  Optional<YamlSection> requiredSection(String key) {
    return required(key).map(value -> new YamlSection(text, value, pointer(key), problems));
  }

  List<YamlSection> sections(String key) {
    List<YamlSection> sections = new ArrayList<>();
    List<Node> items = items(key);
    for (int i = 0; i < items.size(); i++) {
      sections.add(new YamlSection(text, items.get(i), pointer(key) + "/" + i, problems));
    }
    return sections;
  }

  private List<Node> items(String key) {
    Optional<Node> value = value(key);
    if (value.isEmpty()) {
      return List.of();
    }
    if (value.get() instanceof SequenceNode sequence) {
      return sequence.getValue();
    }
    problem("scenario.value.type", "A list is expected here.", value.get(), pointer(key));
    return List.of();
  }

  /** Reports the keys that nobody asked for. */
  void finish() {
    entries.forEach(
        (key, entry) -> {
          if (!known.contains(key)) {
            Diagnostic unknown =
                Diagnostic.error(
                    "scenario.key.unknown",
                    "There is no key " + key + " here.",
                    locate(entry.getKeyNode(), pointer(key)));
            problems.add(unknown.withHint("Keys here: " + String.join(", ", known) + "."));
          }
        });
  }

  /** Reports that the section as a whole lacks something. */
  void missing(String message) {
    problem("scenario.key.missing", message, node, pointer);
  }

  /** Reports a value of the right type that cannot be. */
  void problem(String id, String message, String key) {
    problem(id, message, entries.get(key).getValueNode(), pointer(key));
  }

  private void problem(String id, String message, Node at, String element) {
    problems.add(Diagnostic.error(id, message, locate(at, element)));
  }

  private String pointer(String key) {
    return pointer + "/" + key.replace("~", "~0").replace("/", "~1");
  }

  /** The place of a mark; the whole file without one. */
  static SourceLocation locate(SourceText text, Mark mark) {
    return mark == null
        ? SourceLocation.of(text.name())
        : text.at(mark.getLine() + 1, mark.getColumn() + 1);
  }

  private SourceLocation locate(Node at, String element) {
    return locate(text, at.getStartMark()).withElement(element);
  }
}
