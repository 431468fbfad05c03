package dev.eventchain.simulation.stage;

import dev.eventchain.openscenario.document.ScenarioFile;
import dev.eventchain.roads.RoadNetwork;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Files in OpenSCENARIO XML, with their catalogs, and the maps of their roads, each of which is
 * read once. Several threads may ask.
 */
public final class PlayedFiles {

  private final Map<Path, ScenarioFile> scenarios = new ConcurrentHashMap<>();
  private final Map<Path, RoadNetwork> networks = new ConcurrentHashMap<>();

  ScenarioFile scenario(Path file) {
    return scenarios.computeIfAbsent(
        file, it -> ScenarioFile.read(it, it.toAbsolutePath().getRoot()));
  }

  RoadNetwork network(Path file) {
    return networks.computeIfAbsent(file, RoadNetwork::read);
  }
}
