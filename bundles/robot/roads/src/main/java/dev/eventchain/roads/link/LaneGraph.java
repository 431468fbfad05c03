package dev.eventchain.roads.link;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The ends of lanes that are linked, in both directions whichever side the file states. */
public final class LaneGraph {

  private final Map<LaneEnd, Set<LaneEnd>> links = new LinkedHashMap<>();

  /** Links two ends with each other. */
  public void add(LaneEnd first, LaneEnd second) {
    links.computeIfAbsent(first, key -> new LinkedHashSet<>()).add(second);
    links.computeIfAbsent(second, key -> new LinkedHashSet<>()).add(first);
  }

  /** Returns the ends at which linked lanes begin, in the order of the file. */
  public List<LaneEnd> from(LaneEnd end) {
    return List.copyOf(links.getOrDefault(end, Set.of()));
  }
}
