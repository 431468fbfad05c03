package dev.eventchain.openscenario.storyboard.tree;

import dev.eventchain.openscenario.document.ScenarioElement;
import java.util.HashMap;
import java.util.Map;

/** Paths of the elements below one, all different: the second of a name gets {@code #2}. */
final class Names {

  private final String prefix;
  private final Map<String, Integer> counts = new HashMap<>();

  Names(String prefix) {
    this.prefix = prefix;
  }

  String path(ScenarioElement element) {
    String name = element.text("name");
    int count = counts.merge(name, 1, Integer::sum);
    return prefix + name + (count > 1 ? "#" + count : "");
  }
}
