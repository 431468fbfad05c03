package dev.eventchain.simulation.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that components do not execute with outdated inputs, and that the report says so. */
class InputAgesTest {

  @TempDir Path folder;

  private SimulationResult simulate(Consumer<EventChain> change) throws Exception {
    return AebProject.of(
            folder,
            chain -> {
              // A scan every 700 ms, from a component with a period of 50 ms.
              chain.getSoftware().get(0).setWorstCaseExecutionTime(690);
              change.accept(chain);
            })
        .simulate(List.of(AebProject.scenario("empty-road")));
  }

  private static List<Diagnostic> tooOld(SimulationResult result) {
    return result.diagnostics().stream()
        .filter(each -> each.id().equals("simulation.input.too-old"))
        .toList();
  }

  private static double most(SimulationResult result, String signal) {
    return result.verdicts().get(0).figures().stream()
        .filter(each -> each.name().equals(signal))
        .filter(each -> each.statistic() == ScenarioVerdict.Statistic.MAXIMUM)
        .findFirst()
        .orElseThrow()
        .value();
  }

  @Test
  void inputsOlderThanFivePeriodsOfTheirWriterAreFound() throws Exception {
    SimulationResult result = simulate(chain -> {});

    Diagnostic first = tooOld(result).get(0);
    assertEquals(Severity.WARNING, first.severity());
    assertEquals("TTC_Calculation", first.location().element());
    assertTrue(first.message().startsWith("Scenario empty-road: /scan was "), first.message());
    assertTrue(first.message().contains("at most 250 ms are allowed"), first.message());
  }

  @Test
  void agesThatTheModelAllowsAreNone() throws Exception {
    SimulationResult result =
        simulate(chain -> chain.getData().forEach(data -> data.setMaximumAge(10_000)));

    assertEquals(List.of(), tooOld(result));
  }

  @Test
  void safeValuesAreCommandedWhileInputsAreTooOld() throws Exception {
    SimulationResult result =
        simulate(
            chain -> chain.getSoftware().get(2).getOutput().forEach(d -> d.setSafeValue("0.25")));

    assertEquals(0.25, most(result, "brake"), "the road is empty, the component never brakes");
  }

  @Test
  void silenceThatTheModelHasAgesAndSafeValuesForIsNoWarning() throws Exception {
    SimulationResult result =
        simulate(
            chain -> {
              chain.getSoftware().get(1).getInput().forEach(data -> data.setMaximumAge(300));
              chain.getSoftware().get(1).getOutput().forEach(data -> data.setSafeValue("1000.0"));
            });

    Diagnostic first = tooOld(result).get(0);
    assertEquals(Severity.INFO, first.severity());
    assertEquals("The safe values of the model were published instead.", first.hint());
  }

  @Test
  void silenceThatOnlyTheUsualAgeIsThereForIsAWarningInSpiteOfSafeValues() throws Exception {
    SimulationResult result =
        simulate(
            chain -> chain.getSoftware().get(1).getOutput().forEach(d -> d.setSafeValue("1000.0")));

    assertEquals(Severity.WARNING, tooOld(result).get(0).severity());
  }
}
