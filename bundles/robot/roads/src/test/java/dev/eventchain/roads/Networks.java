package dev.eventchain.roads;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;

/** The networks of the tests. */
final class Networks {

  static final Path FOLDER = Path.of("src/test/resources/networks");

  private Networks() {}

  /** Returns a network, about which there are no findings. */
  static RoadNetwork read(String name) {
    RoadNetwork network = RoadNetwork.read(FOLDER.resolve(name + ".xodr"));
    assertEquals(List.of(), network.findings());
    return network;
  }
}
