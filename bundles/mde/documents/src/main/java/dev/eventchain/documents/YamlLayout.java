package dev.eventchain.documents;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.yaml.snakeyaml.DumperOptions;
import org.yaml.snakeyaml.Yaml;

/** Layout of YAML files that users may edit. */
public final class YamlLayout {
  private static final int WIDTH = 120;

  private YamlLayout() {}

  /** Returns the text with a final line break; each object without nested ones is on one line. */
  public static String of(JsonNode node) {
    DumperOptions options = new DumperOptions();
    options.setDefaultFlowStyle(DumperOptions.FlowStyle.AUTO);
    options.setIndent(2);
    options.setWidth(WIDTH);
    options.setLineBreak(DumperOptions.LineBreak.UNIX);
    return new Yaml(options).dump(plain(node));
  }

  private static Object plain(JsonNode node) {
    if (node.isArray()) {
      List<Object> elements = new ArrayList<>();
      node.forEach(element -> elements.add(plain(element)));
      return elements;
    }
    if (node.isObject()) {
      Map<String, Object> entries = new LinkedHashMap<>();
      node.properties().forEach(entry -> entries.put(entry.getKey(), plain(entry.getValue())));
      return entries;
    }
    if (node.isNumber()) {
      return node.isIntegralNumber() ? (Object) node.bigIntegerValue() : node.asDouble();
    }
    return node.isBoolean() ? (Object) node.asBoolean() : node.isNull() ? null : node.asText();
  }
}
