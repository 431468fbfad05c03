package dev.eventchain.openscenario.storyboard.tree;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.condition.ElementPaths;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The paths of all elements of a storyboard. */
public final class Paths implements ElementPaths {

  private static final Map<String, String> TYPES =
      Map.of(
          "Story", "story",
          "Act", "act",
          "ManeuverGroup", "maneuverGroup",
          "Maneuver", "maneuver",
          "Event", "event",
          "Action", "action");

  /** An element with the names that lead to it. */
  private record Entry(String type, List<String> names, String path) {}

  private final List<Entry> entries = new ArrayList<>();

  /** Finds those of a storyboard. */
  public Paths(ScenarioElement storyboard) {
    addChildren(storyboard, List.of(), "");
  }

  private void addChildren(ScenarioElement parent, List<String> names, String prefix) {
    // Only elements of one type are below another one, so their names do not meet.
    Names paths = new Names(prefix);
    for (ScenarioElement each : parent.children()) {
      if (TYPES.containsKey(each.name())) {
        List<String> all = new ArrayList<>(names);
        all.add(each.text("name"));
        String path = paths.path(each);
        entries.add(new Entry(TYPES.get(each.name()), List.copyOf(all), path));
        addChildren(each, all, path + "/");
      }
    }
  }

  @Override
  public List<String> find(String type, String reference) {
    List<String> last = List.of(reference.split("::", -1));
    return entries.stream()
        .filter(each -> each.type().equals(type) && endsWith(each.names(), last))
        .map(Entry::path)
        .toList();
  }

  private static boolean endsWith(List<String> names, List<String> last) {
    int from = names.size() - last.size();
    return from >= 0 && names.subList(from, names.size()).equals(last);
  }

  /** Returns the names of the elements of a type, in the order of the file. */
  public List<String> names(String type) {
    return entries.stream()
        .filter(each -> each.type().equals(type))
        .map(each -> each.names().get(each.names().size() - 1))
        .distinct()
        .toList();
  }
}
