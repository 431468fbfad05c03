package dev.eventchain.workspace;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.BooleanNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.LongNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.regex.Pattern;

/** Parameters that a launch file gives a node: those with a name and a value. */
final class LaunchParameters {

  /** The parameter by which a node is told to use simulated time, as a host does anyway. */
  static final String SIMULATED = "use_sim_time";

  private static final ObjectMapper JSON = new ObjectMapper();

  /** Texts that YAML, by which launch files infer types, may take for something else than here. */
  private static final Pattern UNCLEAR =
      Pattern.compile(
          "|[\\[{'\"!&*|>%@`].*|(?i:yes|no|on|off|null|~|[-+]?\\.(inf|nan))"
              + "|[-+]?0[0-9xob_].*|[-+]?[0-9][0-9_:]*[_:][0-9_:.]*",
          Pattern.DOTALL);

  private static final String SAY = "'parameters' of its node in components.json say them.";

  private LaunchParameters() {}

  /**
   * Returns the values of the parameters of a node, by their names.
   *
   * @param value the text of a value with its variables; empty if it is not known
   * @param ask receives questions
   */
  static Map<String, JsonNode> of(
      LaunchElement node, Function<LaunchElement, Optional<String>> value, Consumer<String> ask) {
    Map<String, JsonNode> found = new LinkedHashMap<>();
    for (LaunchElement each : node.children("param")) {
      Optional<String> name = attribute(each, "name");
      Optional<JsonNode> known =
          attribute(each, "json")
              .map(LaunchParameters::json)
              .or(() -> value.apply(each).flatMap(LaunchParameters::inferred));
      if (name.isPresent() && known.isPresent()) {
        if (!name.get().equals(SIMULATED)) {
          found.put(name.get(), known.get());
        }
      } else if (each.attributes().containsKey("from")) {
        String file = attribute(each, "from").map(it -> " '" + it + "'").orElse("");
        ask.accept("Which parameters does the file" + file + " give this node? " + SAY);
      } else {
        String which =
            name.map(it -> "What is the parameter '" + it + "' of").orElse("Which parameters has");
        ask.accept(which + " this node? " + SAY);
      }
    }
    return found;
  }

  private static Optional<String> attribute(LaunchElement element, String name) {
    return element.attributes().getOrDefault(name, Optional.empty());
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
