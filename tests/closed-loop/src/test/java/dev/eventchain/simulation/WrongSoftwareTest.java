package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that a scenario of the AEB example fails components that do something else. */
class WrongSoftwareTest {

  private static final Path MUTANTS = Path.of("src/test/resources/mutants.csv");

  /**
   * A wrong component.
   *
   * @param component the name of the one that it replaces
   * @param scenario the name of the scenario that has to fail it
   */
  private record Mutant(String component, String file, String scenario) {}

  @TempDir Path folder;
  private AebProject project;
  private String original;

  /** One process simulates all of them: it reads the components again before each scenario. */
  @Test
  void aScenarioFailsEachOfThem() throws Exception {
    List<Mutant> mutants =
        Files.readAllLines(MUTANTS).stream()
            .skip(1)
            .map(line -> line.split(",", -1))
            .map(values -> new Mutant(values[0], values[1], values[2]))
            .toList();
    project = new AebProject(folder);
    List<Scenario> wanted =
        mutants.stream().map(each -> AebProject.scenario(each.scenario())).toList();
    int[] next = {0};
    put(mutants.get(0));
    SimulationResult result =
        Simulation.run(
            project.request(wanted).with(settings -> settings.withProcesses(1)),
            PythonEnvironment.ensure(line -> {}),
            verdict -> {
              restore(mutants.get(next[0]));
              if (++next[0] < mutants.size()) {
                put(mutants.get(next[0]));
              }
            });
    assertEquals(mutants.size(), result.verdicts().size());
    for (int i = 0; i < mutants.size(); i++) {
      assertFails(mutants.get(i), result.verdicts().get(i));
    }
  }

  private void put(Mutant mutant) {
    try {
      original = Files.readString(project.component(mutant.component()));
      project.with(mutant.component(), "mutants/" + mutant.file());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void restore(Mutant mutant) {
    try {
      Files.writeString(project.component(mutant.component()), original);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void assertFails(Mutant mutant, ScenarioVerdict verdict) {
    assertFalse(verdict.passed(), mutant::toString);
    Diagnostic finding = verdict.diagnostics().get(0);
    assertEquals("simulation.criterion.failed", finding.id(), mutant::toString);
    String file = finding.location().file();
    assertTrue(file.endsWith(mutant.scenario() + ".yaml"), () -> mutant + ": " + file);
    assertTrue(finding.location().line() > 0, mutant::toString);
  }
}
