package dev.eventchain.openscenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.openscenario.document.ResolvedScenario;
import dev.eventchain.openscenario.document.ScenarioFile;
import dev.eventchain.openscenario.document.Variations;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Cases from distributions, in our files and in those of the second author. */
class VariationsTest {

  private static final Path LIBRARY = Path.of("src/test/resources/library");
  private static final Path SECOND_AUTHOR = Path.of("src/test/resources/second-author");

  private static List<Map<String, String>> cases(String file) {
    return Variations.read(SECOND_AUTHOR.resolve(file), SECOND_AUTHOR).cases();
  }

  @Test
  void distributionsMultiplyInTheirOrder() {
    Variations variations =
        Variations.read(LIBRARY.resolve("scenarios/rear-end/variations/standing.xosc"), LIBRARY);
    List<Map<String, String>> cases = variations.cases();
    assertEquals(45, cases.size());
    assertEquals(Map.of("row", "standing", "ego_kph", "10", "overlap", "-50"), cases.get(0));
    assertEquals(Map.of("row", "standing", "ego_kph", "10", "overlap", "-75"), cases.get(1));
    assertEquals(Map.of("row", "standing", "ego_kph", "50", "overlap", "50"), cases.get(44));
    for (Map<String, String> values : cases) {
      ResolvedScenario scenario = variations.scenario().resolve(values);
      double speed = Double.parseDouble(values.get("ego_kph")) / 3.6;
      assertEquals(4 * speed, Double.parseDouble(scenario.parameters().get("gap")), 1e-12);
      assertEquals("standing", scenario.parameters().get("row"));
    }
  }

  @Test
  void stepsAreExactDecimalsWithBothEnds() {
    List<Map<String, String>> cases = cases("1.3/steps.xosc");
    assertEquals(
        List.of("0.1", "0.2", "0.3", "0.4", "0.5"),
        cases.stream().map(each -> each.get("speed")).distinct().toList());
    assertEquals(10, cases.size());
  }

  @Test
  void setsOfValuesStayTogether() {
    assertEquals(
        List.of(
            Map.of("speed", "10", "mode", "calm"),
            Map.of("speed", "20", "mode", "wild"),
            Map.of("speed", "30", "mode", "wild")),
        cases("1.3/pairs.xosc"));
  }

  /** The values are known, so that another machine, or a change, cannot have others unseen. */
  @ParameterizedTest
  @CsvSource({
    "normal, 30.099139518441437",
    "uniform, 15.07453340273271",
    "poisson, 21",
    "histogram, 25.074533402732712",
    "log-normal, 33.439806438037095"
  })
  void drawsAreTheSameOnEachMachine(String file, String first) {
    List<Map<String, String>> cases = cases("1.3/" + file + ".xosc");
    assertEquals(200, cases.size());
    assertEquals(first, cases.get(0).get("speed"));
    assertEquals(cases, cases("1.3/" + file + ".xosc"));
    long calm = cases.stream().filter(each -> each.get("mode").equals("calm")).count();
    assertTrue(calm > 125 && calm < 175, calm + " of 200 with the weight 3 to 1");
  }

  /**
   * Means and variances of 200 draws, within four standard errors.
   *
   * @param mean the expected value
   * @param variance the variance
   */
  @ParameterizedTest
  @CsvSource({
    "uniform, 15, 8.3333",
    "poisson, 20, 20",
    "histogram, 22.5, 27.0833",
    "log-normal, 30, 4"
  })
  void drawsHaveTheMomentsOfTheirDistribution(String file, double mean, double variance) {
    List<Double> values =
        cases("1.3/" + file + ".xosc").stream()
            .map(each -> Double.parseDouble(each.get("speed")))
            .toList();
    double actual = average(values, value -> value);
    double spread = average(values, value -> (value - actual) * (value - actual));
    assertEquals(mean, actual, 4 * Math.sqrt(variance / values.size()));
    assertEquals(variance, spread, variance * 0.4);
  }

  private static double average(List<Double> values, ToDoubleFunction<Double> of) {
    return values.stream().mapToDouble(of).average().orElseThrow();
  }

  @Test
  void drawsOutsideTheRangeAreRepeated() {
    for (Map<String, String> values : cases("1.3/normal.xosc")) {
      double speed = Double.parseDouble(values.get("speed"));
      assertTrue(speed >= 28 && speed <= 33, values.toString());
    }
  }

  @Test
  void anotherSeedGivesOtherDrawsAndOtherParametersDoNot(@TempDir Path folder) throws IOException {
    Files.copy(SECOND_AUTHOR.resolve("1.3/everything.xosc"), folder.resolve("everything.xosc"));
    String text = Files.readString(SECOND_AUTHOR.resolve("1.3/uniform.xosc"));
    Path file = folder.resolve("uniform.xosc");
    Files.writeString(file, text.replace("randomSeed=\"7\"", "randomSeed=\"8\""));
    List<Map<String, String>> known = cases("1.3/uniform.xosc");
    assertTrue(!known.get(0).equals(Variations.read(file, folder).cases().get(0)));
    int second = text.lastIndexOf("<StochasticDistribution ");
    int end = text.indexOf("</Stochastic>");
    Files.writeString(file, text.substring(0, second) + text.substring(end));
    assertEquals(
        known.stream().map(each -> each.get("speed")).toList(),
        Variations.read(file, folder).cases().stream().map(each -> each.get("speed")).toList());
  }

  static Stream<Path> filesOfTheSecondAuthor() throws IOException {
    try (Stream<Path> files = Files.walk(SECOND_AUTHOR)) {
      return new ArrayList<>(
              files.filter(file -> file.toString().endsWith(".xosc")).sorted().toList())
          .stream();
    }
  }

  @ParameterizedTest
  @MethodSource("filesOfTheSecondAuthor")
  void filesOfTheSecondAuthorAreReadWithoutAFinding(Path path) {
    ScenarioFile file = ScenarioFile.read(path, SECOND_AUTHOR);
    assertEquals(List.of(), file.warnings());
    switch (file.kind()) {
      case SCENARIO -> {
        ResolvedScenario scenario = file.resolve(Map.of());
        assertEquals(List.of(), scenario.warnings());
        assertEquals("36", scenario.parameters().get("speed"));
      }
      case CATALOG ->
          assertEquals(1, file.element().child("Catalog").orElseThrow().children().size());
      case DISTRIBUTION -> assertTrue(Variations.of(file).cases().size() > 1);
    }
  }
}
