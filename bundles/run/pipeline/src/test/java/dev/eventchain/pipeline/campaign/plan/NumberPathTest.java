package dev.eventchain.pipeline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.math.BigDecimal;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests where paths of numbers lead. */
class NumberPathTest {

  private static final String FILE =
      """
      {"ego": {"v": 1, "name": "x"},
       "actors": [{"name": "car", "gap": 2}, {"name": "a walker", "gap": 3, "maneuvers": [{"at": 1}]}],
       "inputs": {"driver.set_speed": 5, "driver": {"pressed": 1}, "radar.reach": {"value": 7}},
       "provides": {"/radar/target": {"rate": 50}}}
      """;

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "ego.v; /ego/v",
        "ego.width; /ego/width",
        "road.curve; /road/curve",
        "seed; /seed",
        "actors[0].gap; /actors/0/gap",
        "actors[a walker].gap; /actors/1/gap",
        "actors[a walker].maneuvers[0].at; /actors/1/maneuvers/0/at",
        "inputs.driver.set_speed; /inputs/driver.set_speed",
        "inputs.driver.pressed; /inputs/driver/pressed",
        "inputs.radar.reach.value; /inputs/radar.reach/value",
        "provides./radar/target.rate; /provides/~1radar~1target/rate",
      })
  void aPathLeadsToItsNumber(String path, String pointer) throws Exception {
    ObjectNode file = (ObjectNode) new ObjectMapper().readTree(FILE);
    assertEquals(Optional.of(pointer), new NumberPath(path).pointer(file));
    new NumberPath(path).in(file).set(new BigDecimal("1234"));
    assertEquals(1234, file.at(pointer).intValue(), file::toString);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "ego..v; 'ego..v' is no path, such as actors[0].gap_m.",
        "ego.[0]; There is no [0] for the path 'ego.[0]'.",
        "ego.name; 'ego.name' is not the path of a number.",
        "ego; 'ego' is not the path of a number.",
        "ego.v.x; There is no x for the path 'ego.v.x'.",
        "actors; 'actors' is not the path of a number.",
        "actors[0]; 'actors[0]' is not the path of a number.",
        "actors[2].gap; There is no [2] for the path 'actors[2].gap', but [car], [a walker].",
        "actors[bus].gap; There is no [bus] for the path 'actors[bus].gap', but [car], [a walker].",
        "actors.gap; There is no gap for the path 'actors.gap'.",
        "furniture[0].gap; There is no furniture for the path 'furniture[0].gap'.",
      })
  void whatIsWrongWithAPathIsSaid(String path, String problem) throws IOException {
    ObjectNode file = (ObjectNode) new ObjectMapper().readTree(FILE);
    NumberPath.WrongPathException wrong =
        assertThrows(NumberPath.WrongPathException.class, () -> new NumberPath(path).in(file));
    assertEquals(problem, wrong.getMessage());
  }
}
