package dev.eventchain.pipeline.campaign.plan;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.simulation.scenario.VariedScenario;
import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.StreamSupport;

/** The paths by which factors of campaigns name the numbers of a scenario or a bench. */
public final class FactorPaths {

  private static final String NAME = "name";
  private static final Pattern NUMBER =
      Pattern.compile("[-+]?(?:[0-9]++(?:\\.[0-9]*+)?|\\.[0-9]++)(?:[eE][-+]?[0-9]{1,3})?");
  private static final List<JsonNode> MISSING = List.of(MissingNode.getInstance());

  private final ObjectNode root;
  private final String prefix;
  private final Map<String, String> found = new LinkedHashMap<>();
  private final IdentityHashMap<ArrayNode, Map<String, List<JsonNode>>> lists =
      new IdentityHashMap<>();

  private FactorPaths(ObjectNode root, String prefix) {
    this.root = root;
    this.prefix = prefix;
  }

  /** Returns the paths of the numbers of a scenario, each with its number, in its order. */
  public static Map<String, String> ofScenario(SourceText text) {
    return of(text, "");
  }

  /** As {@link #ofScenario}, of the bench of a project. */
  public static Map<String, String> ofBench(SourceText text) {
    return of(text, NumberPath.BENCH);
  }

  /**
   * As {@link #ofScenario}, of the parameters of a file in OpenSCENARIO XML that are numbers; none
   * of another file, or of one that cannot be read.
   */
  public static Map<String, String> ofPlayed(Path file) {
    Map<String, String> found = new LinkedHashMap<>();
    try {
      if (VariedScenario.isOne(file)) {
        VariedScenario.read(file).declared().entrySet().stream()
            .filter(each -> NUMBER.matcher(each.getValue()).matches())
            .forEach(each -> found.put(PlayedScenario.PATH + each.getKey(), each.getValue()));
      }
    } catch (DiagnosticException e) {
      // Its own check says what is wrong with it.
    }
    return found;
  }

  private static Map<String, String> of(SourceText text, String prefix) {
    try {
      JsonNode root =
          Document.parse(text, DocumentFormat.YAML, CampaignRules.OF_DOCUMENTS, problem -> {})
              .root();
      if (root instanceof ObjectNode object) {
        FactorPaths paths = new FactorPaths(object, prefix);
        paths.add(object, "");
        return paths.found;
      }
    } catch (DiagnosticException e) {
      // Its own check says what is wrong with it.
    }
    return Map.of();
  }

  private void add(JsonNode node, String path) {
    if (node instanceof ObjectNode object) {
      String start = path.isEmpty() ? "" : path + ".";
      object.properties().forEach(each -> add(each.getValue(), start + each.getKey()));
    } else if (node instanceof ArrayNode list) {
      for (int i = 0; i < list.size(); i++) {
        add(list.get(i), path + "[" + element(list, i) + "]");
      }
    } else if (node.isNumber() && leadsTo(path, node)) {
      found.put(prefix + path, node.asText());
    }
  }

  /** Returns an element's name, or its number if it has none, or not for itself. */
  private String element(ArrayNode list, int index) {
    String name = list.get(index).path(NAME).asText();
    return name.isBlank() || named(list).get(name).size() > 1 ? String.valueOf(index) : name;
  }

  /** Returns the elements of a list by their names. */
  private Map<String, List<JsonNode>> named(ArrayNode list) {
    return lists.computeIfAbsent(
        list,
        each ->
            StreamSupport.stream(each.spliterator(), false)
                .collect(Collectors.groupingBy(element -> element.path(NAME).asText())));
  }

  /** Returns whether a path is read as it is meant: keys and names may have any characters. */
  @SuppressWarnings("ReferenceEquality") // Equal numbers stand at many places.
  private boolean leadsTo(String path, JsonNode number) {
    return new NumberPath(path)
        .find(root, (list, name) -> named(list).getOrDefault(name, MISSING).get(0))
        .filter(each -> each == number)
        .isPresent();
  }
}
