package dev.eventchain.pipeline.campaign.plan;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import java.util.LinkedHashMap;
import java.util.Map;

/** The paths by which factors of campaigns name the numbers of a scenario or a bench. */
public final class FactorPaths {

  private static final String NAME = "name";

  private final ObjectNode root;
  private final String prefix;
  private final Map<String, String> found = new LinkedHashMap<>();

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
  private static String element(ArrayNode list, int index) {
    String name = list.get(index).path(NAME).asText();
    int same = 0;
    for (JsonNode each : list) {
      same += each.path(NAME).asText().equals(name) ? 1 : 0;
    }
    return name.isBlank() || same > 1 ? String.valueOf(index) : name;
  }

  /** Returns whether a path is read as it is meant: keys and names may have any characters. */
  private boolean leadsTo(String path, JsonNode number) {
    try {
      NumberPath.Place place = new NumberPath(path).in(root.deepCopy());
      return number.equals(place.owner().get(place.key()));
    } catch (NumberPath.WrongPathException e) {
      return false;
    }
  }
}
