package dev.eventchain.openscenario.storyboard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import dev.eventchain.openscenario.document.ScenarioFile;
import dev.eventchain.openscenario.storyboard.network.NetworkRoads;
import dev.eventchain.openscenario.storyboard.tree.Change;
import dev.eventchain.openscenario.storyboard.world.Collisions;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.roads.RoadNetwork;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Plays the scenarios of {@code standard} and compares what happens with what the standard's text
 * says has to happen, which was derived by hand and is in the file {@code .expected} beside each.
 *
 * <p>Its lines are {@code element NAME (TIME TRANSITION)*}, all transitions of an element; {@code
 * state TIME ENTITY QUANTITY VALUE TOLERANCE?}; {@code value TIME VARIABLE VALUE}; and {@code end
 * TIME}, the end of the storyboard.
 */
class StandardTest {

  private static final Path FOLDER = Path.of("src", "test", "resources", "standard");

  private static final double EXACT = 1e-3;

  static List<String> scenarios() throws Exception {
    try (Stream<Path> files = Files.list(FOLDER)) {
      List<String> names =
          files
              .map(file -> file.getFileName().toString())
              .filter(name -> name.endsWith(".xosc"))
              .map(name -> name.replace(".xosc", ""))
              .sorted()
              .toList();
      assertFalse(names.isEmpty());
      return names;
    }
  }

  /** States and values come in the order of their times; elements are looked at in the end. */
  @ParameterizedTest
  @MethodSource("scenarios")
  void happensAsTheStandardSays(String name) throws Exception {
    StoryboardRun run = start(FOLDER.resolve(name + ".xosc"));
    List<String> expected = Files.readAllLines(FOLDER.resolve(name + ".expected"));
    List<String> actual = new ArrayList<>();
    for (String line : sorted(expected)) {
      String[] words = line.split(" ", -1);
      switch (words[0]) {
        case "state" -> actual.add(state(played(run, words[1]), words));
        case "value" -> actual.add(value(played(run, words[1]), words));
        case "end" -> actual.add("end " + end(run));
        default -> actual.add(element(played(run, "20"), words[1]));
      }
    }
    assertEquals(String.join("\n", sorted(expected)), String.join("\n", actual));
  }

  private static List<String> sorted(List<String> lines) {
    return lines.stream()
        .sorted(
            (one, other) -> {
              int kind = Boolean.compare(one.startsWith("element"), other.startsWith("element"));
              return kind != 0 ? kind : Double.compare(time(one), time(other));
            })
        .toList();
  }

  private static double time(String line) {
    return line.startsWith("element") ? 0 : Double.parseDouble(line.split(" ", -1)[1]);
  }

  private static StoryboardRun start(Path file) {
    ScenarioFile read = ScenarioFile.read(file);
    Path roads = file.resolveSibling(read.roadNetwork().orElseThrow());
    var resolved = read.resolve(Map.of());
    return StoryboardRun.start(
        resolved.root(),
        resolved.parameters(),
        new NetworkRoads(RoadNetwork.read(roads)),
        "Ego",
        Optional.empty());
  }

  private static StoryboardRun played(StoryboardRun run, String until) {
    while (run.time() < Double.parseDouble(until) - Scenarios.STEP / 2 && !run.ended()) {
      run.advance(Scenarios.STEP, Optional.empty(), Collisions.NONE);
    }
    return run;
  }

  private static String end(StoryboardRun run) {
    played(run, "100");
    return String.format(Locale.ROOT, "%.2f", run.time());
  }

  /** Returns the line itself if the state is as it says. */
  private static String state(StoryboardRun run, String[] words) {
    EntityState state = run.states().get(words[2]);
    double actual =
        switch (words[3]) {
          case "x" -> state.pose().x();
          case "y" -> state.pose().y();
          case "heading" -> Math.abs(state.pose().heading());
          case "s" -> state.road().orElseThrow().s();
          default -> state.speed();
        };
    double tolerance = words.length > 5 ? Double.parseDouble(words[5]) : EXACT;
    boolean same = Math.abs(actual - Double.parseDouble(words[4])) <= tolerance;
    words[4] = same ? words[4] : String.format(Locale.ROOT, "%.6f", actual);
    return String.join(" ", words);
  }

  private static String value(StoryboardRun run, String[] words) {
    words[3] = run.variables().get(words[2]);
    return String.join(" ", words);
  }

  private static String element(StoryboardRun run, String name) {
    return run.changes().stream()
        .filter(each -> each.transition() != null)
        .filter(each -> each.path().substring(each.path().lastIndexOf('/') + 1).equals(name))
        .map(StandardTest::text)
        .collect(Collectors.joining("", "element " + name, ""));
  }

  private static String text(Change change) {
    return String.format(Locale.ROOT, " %.2f %s", change.time(), change.transition());
  }
}
