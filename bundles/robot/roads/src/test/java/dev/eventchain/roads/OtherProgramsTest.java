package dev.eventchain.roads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.roads.road.Pose;
import dev.eventchain.roads.road.Road;
import java.io.IOException;
import java.nio.file.Files;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Compares places with those of other programs; {@code src/test/python} says which. */
class OtherProgramsTest {

  private static final double CENTIMETRE = 0.01;

  private final Map<String, RoadNetwork> networks = new HashMap<>();

  @Test
  void placesAgree() throws IOException {
    List<String> rows = Files.readAllLines(Networks.FOLDER.resolve("places.csv"));
    int compared = 0;
    for (String row : rows.subList(1, rows.size())) {
      String[] cells = row.split(",", -1);
      RoadNetwork network = networks.computeIfAbsent(cells[0], Networks::read);
      Road road = network.road(cells[1]).orElseThrow();
      double s = Double.parseDouble(cells[2]);
      Pose pose = road.pose(s, t(road, s, cells[3], cells[4]));
      assertEquals(Double.parseDouble(cells[5]), pose.x(), CENTIMETRE, row);
      assertEquals(Double.parseDouble(cells[6]), pose.y(), CENTIMETRE, row);
      if (!cells[7].isEmpty()) {
        double turned =
            Math.IEEEremainder(pose.heading() - Double.parseDouble(cells[7]), 2 * Math.PI);
        assertEquals(0, turned, 1e-4, row);
      }
      compared++;
    }
    assertTrue(compared > 1000, "compared " + compared);
  }

  private static double t(Road road, double s, String lane, String edge) {
    return switch (edge) {
      case "inner" -> road.section(s).innerEdge(Integer.parseInt(lane), s);
      case "outer" -> road.section(s).outerEdge(Integer.parseInt(lane), s);
      default -> 0;
    };
  }
}
