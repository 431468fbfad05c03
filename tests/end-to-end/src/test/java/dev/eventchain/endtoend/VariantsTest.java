package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Thorough;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;

/**
 * Tests that the scenarios of the examples pass software of others that does what the requirements
 * say in another way: with other components in the same design, or by another design. The mutants
 * of {@link MutantsTest} are the other side. A build tries one of one example, another one each
 * day; the profile {@code thorough} tries all. {@code -Dmutants.turn=N} repeats a build's.
 */
class VariantsTest {

  private static final Path VARIANTS =
      Program.ROOT.resolve("tests/end-to-end/src/test/resources/variants");

  private static final ObjectMapper JSON = new ObjectMapper();

  /** Software of other designs: other components, topics and ways to calculate. */
  private static final Path DESIGNS =
      Program.ROOT.resolve("tests/end-to-end/src/test/resources/designs");

  private static final List<String> EXAMPLES = List.of("aeb", "acc", "lane-departure", "radar-aeb");

  private static final int FEWEST = 4;

  @TempDir Path folder;

  static Stream<String> examples() {
    return Thorough.allOrOne(EXAMPLES).stream();
  }

  static Stream<Path> someDesigns() throws Exception {
    List<Path> some = new ArrayList<>();
    for (String example : Thorough.allOrOne(EXAMPLES)) {
      List<Path> designs = designs(example);
      int one = Math.floorMod(InTurn.Condition.round() / EXAMPLES.size(), designs.size());
      some.addAll(Thorough.IS_ON ? designs : List.of(designs.get(one)));
    }
    return some.stream();
  }

  @InTurn
  @ParameterizedTest
  @MethodSource("examples")
  void scenariosPassSoftwareOfOthers(String example) throws Exception {
    List<?> variants = (List<?>) read(VARIANTS.resolve(example + ".yaml")).get("variants");
    assertTrue(variants.size() >= FEWEST, "too few to speak of");
    List<Path> designs = designs(example);
    assertTrue(designs.size() >= FEWEST, "too few to speak of");
    int one =
        Math.floorMod(InTurn.Condition.round() / EXAMPLES.size(), variants.size() + designs.size());
    for (Path design : designs) {
      if (Thorough.IS_ON || one == variants.size() + designs.indexOf(design)) {
        pass(example, design);
      }
    }
    if (Thorough.IS_ON || one < variants.size()) {
      pass(example, Thorough.IS_ON ? variants : variants.subList(one, one + 1));
    }
  }

  /** The bounds of an example are met by other designs, too: none depends on how one is divided. */
  @InTurn
  @ParameterizedTest
  @MethodSource("someDesigns")
  void scenariosAreAsSharpForDesignsOfOthers(Path design) throws Exception {
    Path example = Program.ROOT.resolve("examples").resolve(design.getParent().getFileName());
    Path project = folder.resolve("strength");
    DesignProject.run(example, design, project, "--strength").expect(0).says("PASSED: ");
    JsonNode verdict = JSON.readTree(project.resolve("out/verdict.json").toFile());
    for (JsonNode requirement : verdict.path("requirements")) {
      JsonNode bound = requirement.path("strength").path("bound");
      assertTrue(bound.path("faults").asInt() > 0, requirement::toString);
    }
  }

  private static List<Path> designs(String example) throws Exception {
    try (Stream<Path> files = Files.list(DESIGNS.resolve(example))) {
      return files.sorted().toList();
    }
  }

  private void pass(String example, Path design) throws Exception {
    String name = design.getFileName().toString().replace(".yaml", "");
    DesignProject.run(
            Program.ROOT.resolve("examples").resolve(example),
            design,
            folder.resolve(name),
            "--no-strength")
        .expect(0)
        .says("PASSED: ");
  }

  private void pass(String example, List<?> variants) throws Exception {
    MutantRun run = MutantRun.of(example, folder);
    Set<String> wrong = new LinkedHashSet<>();
    for (Object variant : variants) {
      wrong.addAll(complaints((Map<?, ?>) variant, run));
    }
    assertEquals(Set.of(), wrong, () -> String.join("\n", wrong));
  }

  private static Map<?, ?> read(Path file) throws Exception {
    return new Yaml(new SafeConstructor(new LoaderOptions())).load(Files.readString(file));
  }

  private static Set<String> complaints(Map<?, ?> variant, MutantRun run) throws Exception {
    List<MutantRun.Trial> trials =
        run.scenarios().stream()
            .map(
                scenario -> new MutantRun.Trial(Mutant.variant(variant, scenario.name()), scenario))
            .toList();
    Set<String> wrong = new LinkedHashSet<>();
    Set<String> judged = new TreeSet<>();
    List<ScenarioVerdict> verdicts = run.simulate(trials);
    for (int i = 0; i < trials.size(); i++) {
      judged.addAll(verdicts.get(i).requirements());
      if (!verdicts.get(i).passed()) {
        wrong.add(trials.get(i) + " does not pass: " + verdicts.get(i).diagnostics());
      }
    }
    Set<String> named = new TreeSet<>();
    run.scenarios().stream().map(Scenario::requirements).forEach(named::addAll);
    assertEquals(named, judged, () -> variant.get("id") + " leaves a requirement unproved");
    return wrong;
  }
}
