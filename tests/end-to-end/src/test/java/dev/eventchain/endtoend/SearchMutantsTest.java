package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests that a search over four factors around a scenario finds a failure of each mutant that the
 * scenario fails, within 200 runs in most of five seeds, and none of the example itself.
 */
class SearchMutantsTest {

  private static final Path RESOURCES = Program.ROOT.resolve("tests/end-to-end/src/test/resources");
  private static final int SEEDS = 5;
  private static final List<String> FOLDERS = List.of("software-base/components", "out/components");

  @TempDir Path folder;
  private Path project;

  @ParameterizedTest
  @CsvSource({
    "lane-departure, drift-left",
    "lane-departure, along-the-line",
    "aeb, danger-at-start",
    "aeb, each-component"
  })
  void theDefectsThatAScenarioFailsAreFoundAroundIt(String example, String scenario)
      throws IOException {
    assumeTrue(Thorough.IS_ON, "takes many minutes");
    prepare(example);
    String campaign =
        Files.readString(RESOURCES.resolve("search/%s-%s.yaml".formatted(example, scenario)));
    assertEquals(0, runsToTheFirstFailure(campaign, 1), "a failure of the example itself");
    List<String> missed = new ArrayList<>();
    for (Mutant mutant : Mutant.read(RESOURCES.resolve("mutants/" + example + ".yaml"))) {
      if (mutant.scenario().equals(scenario) && mutant.equivalent().isEmpty()) {
        List<Integer> runs = runs(mutant, campaign);
        if (Collections.frequency(runs, 0) > SEEDS / 2) {
          missed.add(mutant + ": " + runs);
        }
      }
    }
    assertEquals(List.of(), missed);
  }

  /** Generated components may be changed, but then fail their own tests. */
  private void prepare(String example) throws IOException {
    project = Program.copyOf(example, folder);
    Files.writeString(
        project.resolve("eventchain-suppressions.yaml"),
        "[{id: component.test.failed, reason: It is a defect., expires: 2098-12-31}]\n");
    new Program().run("run", project, "--to", "generate").expect(0);
    for (String each : FOLDERS) {
      if (Files.exists(project.resolve(each))) {
        Projects.copy(project.resolve(each), folder.resolve("original").resolve(each));
      }
    }
  }

  /** Returns the first failures of as many seeds as decide what most of them do. */
  private List<Integer> runs(Mutant mutant, String campaign) throws IOException {
    putIntoTheProject(mutant);
    List<Integer> runs = new ArrayList<>();
    for (int seed = 1; !isDecided(runs); seed++) {
      runs.add(runsToTheFirstFailure(campaign, seed));
    }
    return runs;
  }

  private static boolean isDecided(List<Integer> runs) {
    int missed = Collections.frequency(runs, 0);
    return Math.max(missed, runs.size() - missed) > SEEDS / 2;
  }

  private void putIntoTheProject(Mutant mutant) throws IOException {
    Path changed = folder.resolve("changed");
    Files.createDirectories(changed);
    for (String each : FOLDERS) {
      copyFiles(folder.resolve("original").resolve(each), changed);
    }
    mutant.putInto(changed);
    for (String each : FOLDERS) {
      copyFiles(folder.resolve("original").resolve(each), project.resolve(each));
      for (Mutant.Change change : mutant.changes()) {
        Path file = project.resolve(each).resolve(change.component() + ".py");
        if (Files.exists(file)) {
          Files.writeString(file, Files.readString(changed.resolve(file.getFileName())));
        }
      }
    }
  }

  private static void copyFiles(Path from, Path to) throws IOException {
    if (!Files.exists(from)) {
      return;
    }
    try (Stream<Path> files = Files.list(from)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        Files.writeString(to.resolve(file.getFileName()), Files.readString(file));
      }
    }
  }

  /** Returns the number of the first run that failed; 0 if none did. */
  private int runsToTheFirstFailure(String campaign, int seed) {
    try {
      Path file = folder.resolve("search.yaml");
      String settings =
          String.format(Locale.ROOT, "seed: %d%nsearch: {runs: 200, stop: first_failure}%n", seed);
      Files.writeString(file, campaign + settings);
      Program.Ended ended = new Program().run("search", project, file);
      assertFalse(ended.code() > 1, ended::toString);
      List<String> rows = Files.readAllLines(project.resolve("out/searches/search/cases.csv"));
      int first =
          IntStream.range(1, rows.size())
              .filter(i -> rows.get(i).contains(",failed,"))
              .findFirst()
              .orElse(0);
      assertEquals(first > 0, ended.out().contains("found: "), ended::toString);
      return first;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
