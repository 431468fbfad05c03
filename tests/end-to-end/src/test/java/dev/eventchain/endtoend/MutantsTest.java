package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.Thorough;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests that the scenarios of the examples fail components with safety-relevant defects, and by the
 * criterion that concerns the defect. A build tries one in {@link Thorough#DAYS} mutants, at least
 * one of each example, other ones each day; the profile {@code thorough} tries all. {@code
 * -Dmutants.turn=N} repeats a build's.
 */
class MutantsTest {

  private static final Path MUTANTS =
      Program.ROOT.resolve("tests/end-to-end/src/test/resources/mutants");

  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource({"acc, 60", "aeb, 100", "lane-departure, 30"})
  void scenariosFailEachMutantByItsCriterion(String example, int fewest) throws Exception {
    List<Mutant> mutants = Mutant.read(MUTANTS.resolve(example + ".yaml"));
    Set<String> ids = mutants.stream().map(Mutant::id).collect(Collectors.toSet());
    assertEquals(mutants.size(), ids.size(), "two have the same id");
    int days = Math.min(Thorough.DAYS, mutants.size());
    long turn = Thorough.turn() % days;
    MutantRun run = MutantRun.of(example, folder);
    run.requireComponentsOf(mutants);
    List<MutantRun.Trial> trials =
        IntStream.range(0, mutants.size())
            .filter(index -> index % days == turn)
            .mapToObj(index -> run.trial(mutants.get(index)))
            .toList();
    List<ScenarioVerdict> verdicts = run.simulate(trials);
    Set<String> wrong = new LinkedHashSet<>();
    for (int i = 0; i < trials.size(); i++) {
      complaint(trials.get(i), verdicts.get(i)).ifPresent(wrong::add);
    }
    assertEquals(Set.of(), wrong, () -> "turn " + turn + "\n" + String.join("\n", wrong));
    long caught = mutants.stream().filter(each -> each.equivalent().isEmpty()).count();
    assertTrue(caught >= fewest, () -> caught + " mutants are too few to speak of");
  }

  private static Optional<String> complaint(MutantRun.Trial trial, ScenarioVerdict verdict) {
    if (!verdict.worked()) {
      return Optional.of(trial + " does not work at all");
    }
    if (!trial.mutant().equivalent().isEmpty()) {
      return verdict.passed()
          ? Optional.empty()
          : Optional.of(trial + " fails: " + verdict.diagnostics());
    }
    String criterion = trial.mutant().criterion();
    List<CriterionResult> failed =
        verdict.criteria().stream().filter(each -> each.tested() && !each.passed()).toList();
    return failed.stream().anyMatch(each -> each.text().startsWith(criterion))
        ? Optional.empty()
        : Optional.of(
            trial + " is not failed by '" + criterion + "' but by " + verdict.diagnostics());
  }
}
