package dev.eventchain.workspace.launch;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.BooleanNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.LongNode;
import com.fasterxml.jackson.databind.node.TextNode;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Pattern;

/** Parameters that launch files give nodes: values, and files of them. */
final class LaunchParameters {

  /** The parameter by which a node is told to use simulated time, as a host does anyway. */
  static final String SIMULATED = "use_sim_time";

  /** The end of a question about parameters. */
  static final String SAY = "'parameters' of its node in components.json say them.";

  private static final ObjectMapper JSON = new ObjectMapper();

  /** Texts that YAML, by which launch files infer types, may take for something else than here. */
  private static final Pattern UNCLEAR =
      Pattern.compile(
          "|[\\[{'\"!&*|>%@`].*|(?i:yes|no|on|off|null|~|[-+]?\\.(inf|nan))"
              + "|[-+]?0[0-9xob_].*|[-+]?[0-9][0-9_:]*[_:][0-9_:.]*",
          Pattern.DOTALL);

  /** Attributes with the arguments of a node. */
  private static final List<String> ARGUMENTS = List.of("args", "ros_args");

  private static final Pattern ASSIGNS = Pattern.compile("(^|\\s)(-p|--param\\S*)(\\s|$)");
  private static final Pattern WITHOUT_EFFECT =
      Pattern.compile("\\s*(--ros-args\\s*)?(--log-level\\s+\\S+\\s*)*(--\\s*)?");

  private static final Set<String> KNOWN =
      Set.of("name", "value", "json", "type", "from", "filename", "allow_substs", "text");

  /** Returns whether the arguments of a node may give it parameters. */
  static boolean mayAssign(LaunchElement element, LaunchScope scope) {
    return ARGUMENTS.stream()
        .filter(element.attributes()::containsKey)
        .map(attribute -> scope.text(element, attribute))
        .anyMatch(it -> it.isEmpty() || ASSIGNS.matcher(it.get()).find());
  }

  private final Function<String, Optional<String>> substituted;
  private final Function<LaunchElement, Optional<SourceText>> files;
  private final Questions questions;

  /**
   * Creates a reader.
   *
   * @param substituted returns a text with its variables; empty if one is not known
   * @param files returns the file that an element names; empty if it is not in the workspace
   * @param questions receives what is not known
   */
  LaunchParameters(
      Function<String, Optional<String>> substituted,
      Function<LaunchElement, Optional<SourceText>> files,
      Questions questions) {
    this.substituted = substituted;
    this.files = files;
    this.questions = questions;
  }

  /**
   * Returns what the children of the element of a node assign, in their order.
   *
   * @param nodes the name of the node for values that are not in files
   */
  List<ParameterAssignment> of(LaunchElement node, String nodes) {
    List<ParameterAssignment> found = new ArrayList<>();
    for (LaunchElement each : node.children("param")) {
      if (each.attributes().containsKey("from")) {
        found.addAll(file(each, node));
      } else {
        value(each, "", nodes, node, found);
      }
    }
    return found;
  }

  /** Returns what an element that sets a parameter of all later nodes assigns. */
  List<ParameterAssignment> ofAll(LaunchElement element) {
    if (element.kind().equals("set_parameters_from_file")) {
      return file(element, element);
    }
    List<ParameterAssignment> found = new ArrayList<>();
    value(element, "", ParameterAssignment.ALL, element, found);
    return found;
  }

  private List<ParameterAssignment> file(LaunchElement element, LaunchElement place) {
    Optional<SourceText> file = files.apply(element);
    Optional<String> substitutes =
        element.attributes().getOrDefault("allow_substs", Optional.of("false"));
    if (substitutes.filter(it -> !it.equalsIgnoreCase("false")).isPresent()) {
      file =
          file.flatMap(
              it -> substituted.apply(it.text()).map(text -> SourceText.of(it.name(), text)));
    }
    if (file.isPresent() && substitutes.isPresent()) {
      return ParameterFile.read(file.get(), questions);
    }
    String named = attribute(element, "from").or(() -> attribute(element, "filename")).orElse("");
    String which = named.isEmpty() ? "" : " '" + named + "'";
    ask(place, "Which parameters does the file" + which + " give this node? " + SAY);
    return List.of(ParameterAssignment.unknown());
  }

  private void value(
      LaunchElement element,
      String above,
      String nodes,
      LaunchElement place,
      List<ParameterAssignment> found) {
    Optional<String> name = attribute(element, "name").flatMap(substituted).map(above::concat);
    List<LaunchElement> inner = element.children("param");
    if (name.isEmpty()) {
      ask(place, "Which parameters has this node? " + SAY);
      found.add(ParameterAssignment.unknown());
    } else if (!inner.isEmpty()) {
      inner.forEach(each -> value(each, name.get() + ".", nodes, place, found));
    } else {
      Optional<JsonNode> value = value(element);
      if (value.isEmpty() && !name.get().equals(SIMULATED)) {
        ask(place, "What is the parameter '" + name.get() + "' of this node? " + SAY);
      }
      found.add(new ParameterAssignment(nodes, name.get(), value));
    }
  }

  private Optional<JsonNode> value(LaunchElement element) {
    if (!element.attributes().keySet().stream().allMatch(LaunchParameters::isKnown)) {
      return Optional.empty();
    }
    Optional<JsonNode> stated = attribute(element, "json").map(LaunchParameters::json);
    Optional<String> text = attribute(element, "value").flatMap(substituted);
    if (stated.isPresent() || !element.attributes().containsKey("type")) {
      return stated.or(() -> text.flatMap(LaunchParameters::inferred));
    }
    return text.flatMap(it -> typed(it, attribute(element, "type").orElse("")));
  }

  private static boolean isKnown(String attribute) {
    return KNOWN.contains(attribute) || LaunchCondition.ATTRIBUTES.contains(attribute);
  }

  /** Returns a value of a stated type; empty if that is not known, or the text is of another. */
  private static Optional<JsonNode> typed(String text, String type) {
    if (type.equals("str")) {
      return Optional.of(TextNode.valueOf(text));
    }
    Optional<JsonNode> value = inferred(text);
    return switch (type) {
      case "float" ->
          value.filter(JsonNode::isNumber).map(it -> DoubleNode.valueOf(it.doubleValue()));
      case "int" -> value.filter(JsonNode::isIntegralNumber);
      case "bool" -> value.filter(JsonNode::isBoolean);
      default -> Optional.empty();
    };
  }

  private static Optional<String> attribute(LaunchElement element, String name) {
    return element.attributes().getOrDefault(name, Optional.empty());
  }

  /** Asks about arguments of a node of the workspace, which a host does not give it. */
  void askAboutArguments(LaunchElement element, LaunchScope scope) {
    for (String attribute : ARGUMENTS) {
      Optional<String> given = scope.text(element, attribute);
      boolean isPlain = given.filter(it -> WITHOUT_EFFECT.matcher(it).matches()).isPresent();
      if (element.attributes().containsKey(attribute) && !isPlain) {
        String which = given.map(it -> " '" + it.strip() + "'").orElse("");
        ask(element, "What do the arguments" + which + " change of this node? It gets none.");
      }
    }
  }

  private void ask(LaunchElement element, String text) {
    questions.add(text, element.file(), element.line());
  }

  private static JsonNode json(String text) {
    try {
      return JSON.readTree(text);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("the reader of sources writes JSON", e);
    }
  }

  /** Returns a value as launch files infer its type from a text; empty if that is not clear. */
  private static Optional<JsonNode> inferred(String text) {
    if (UNCLEAR.matcher(text).matches()) {
      return Optional.empty();
    } else if (text.matches("[Tt]rue|TRUE|[Ff]alse|FALSE")) {
      return Optional.of(BooleanNode.valueOf(text.equalsIgnoreCase("true")));
    } else if (text.matches("[-+]?[0-9]{1,18}")) {
      return Optional.of(LongNode.valueOf(Long.parseLong(text)));
    } else if (text.matches("[-+]?([0-9]+\\.[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?")) {
      return Optional.of(DoubleNode.valueOf(Double.parseDouble(text)));
    }
    return Optional.of(TextNode.valueOf(text));
  }
}
