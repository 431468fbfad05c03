package dev.eventchain.catalogue.vss;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.diagnostics.Diagnostic;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The instances of branches: {@code Row[1,2]} or a list of names is a level of branches of its own,
 * and single names are side by side.
 */
final class VssInstances {

  static final String INSTANCES = "instances";

  /** Most nodes that the instances of a catalogue may give. */
  static final int MOST = 200_000;

  private static final String RELATION = "instances_relation";
  private static final Pattern RANGE =
      Pattern.compile("(?<before>[^\\[]*)\\[(?<from>\\d{1,6}),\\s*(?<to>\\d{1,6})](?<after>.*)");

  private final Consumer<Diagnostic> findings;
  private int count;

  VssInstances(Consumer<Diagnostic> findings) {
    this.findings = findings;
  }

  /** Expands a node and all below it. */
  void expand(VssNode node) {
    node.value(INSTANCES).ifPresent(instances -> expand(node, instances));
    List.copyOf(node.children().values()).forEach(this::expand);
  }

  private void expand(VssNode node, VssValue instances) {
    if (node.text(RELATION).equals("sibling")) {
      refuse("Instances beside their branch are not read.", node.value(RELATION).orElseThrow());
      return;
    }
    Map<String, VssNode> described = new LinkedHashMap<>(node.children());
    described.values().removeIf(child -> child.is("instantiate", false));
    node.children().keySet().removeAll(described.keySet());
    node.attributes().remove(INSTANCES);
    List<VssNode> innermost = levels(node, instances);
    described.forEach(
        (name, child) -> {
          if (node.children().containsKey(name)) {
            node.children().get(name).merge(child);
          } else {
            innermost.forEach(leaf -> leaf.children().put(name, counted(child)));
          }
        });
  }

  /** Creates the levels of branches, and returns those of the innermost one. */
  private List<VssNode> levels(VssNode node, VssValue instances) {
    JsonNode written = instances.json();
    List<VssNode> roots = List.of(node);
    List<VssNode> made = new ArrayList<>();
    for (JsonNode level : written.isArray() ? written : List.of(written)) {
      List<String> names = new ArrayList<>();
      (level.isArray() ? level : List.of(level))
          .forEach(each -> names.addAll(names(each, instances)));
      List<VssNode> added = new ArrayList<>();
      for (String name : names) {
        for (VssNode root : roots) {
          VssNode instance = counted(node.instance(name));
          root.children().put(name, instance);
          added.add(instance);
        }
      }
      made.addAll(added);
      if (level.isArray() || names.size() > 1) {
        roots = added;
      }
    }
    return made.stream().filter(each -> each.children().isEmpty()).toList();
  }

  /** Returns the names that an instance stands for: {@code Row1}, {@code Row2} for a range. */
  private List<String> names(JsonNode instance, VssValue place) {
    String text = instance.asText();
    Matcher range = RANGE.matcher(text);
    if (!instance.isValueNode() || text.isBlank()) {
      refuse("An instance is a name, or a list of names.", place);
      return List.of();
    }
    if (!range.matches()) {
      return List.of(text);
    }
    List<String> names = new ArrayList<>();
    int last = Integer.parseInt(range.group("to"));
    for (int i = Integer.parseInt(range.group("from")); i <= last && names.size() < MOST; i++) {
      names.add(range.group("before") + i + range.group("after"));
    }
    if (names.isEmpty()) {
      refuse("'" + text + "' ends before it begins.", place);
    }
    return names;
  }

  /** Returns a copy for one more instance. */
  private VssNode counted(VssNode child) {
    count++;
    if (count > MOST) {
      throw new TooManyException();
    }
    return child.copy();
  }

  private void refuse(String message, VssValue place) {
    findings.accept(Diagnostic.of(CatalogueRules.ENTRY, message, place.key()));
  }

  /** More instances than are read. */
  static final class TooManyException extends RuntimeException {
    private static final long serialVersionUID = 1;
  }
}
