package dev.eventchain.roads.reader;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.roads.link.LaneGraph;
import dev.eventchain.roads.road.Header;
import dev.eventchain.roads.road.Road;
import dev.eventchain.roads.road.Signal;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The content of a file without errors.
 *
 * @param roads by their ids, in the order of the file
 */
public record ReadNetwork(
    Header header,
    Map<String, Road> roads,
    List<Signal.Controller> controllers,
    LaneGraph graph,
    List<Diagnostic> warnings) {

  /** Copies the collections. */
  public ReadNetwork {
    roads = Collections.unmodifiableMap(new LinkedHashMap<>(roads));
    controllers = List.copyOf(controllers);
    warnings = List.copyOf(warnings);
  }
}
