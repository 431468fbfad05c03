package dev.eventchain.pipeline.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.pipeline.results.VerdictFile;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.coverage.SignalCoverage;
import dev.eventchain.simulation.coverage.SignalCoverage.Gap;
import dev.eventchain.simulation.coverage.SignalCoverage.Kind;
import dev.eventchain.simulation.coverage.SignalCoverage.Missing;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests the findings about what no scenario shows. */
class UnshownSignalsTest {

  private static SignalCoverage lamp(String side, Gap... gaps) {
    return new SignalCoverage(
        "/lamp",
        side,
        "",
        Kind.TRUTH,
        "Lamp",
        Double.NaN,
        Double.NaN,
        List.of("false"),
        List.of("true"),
        1,
        List.of(gaps));
  }

  private static SimulationResult result(boolean passed, List<SignalCoverage> signals) {
    ScenarioVerdict verdict =
        new ScenarioVerdict(
            "drift",
            "Drift",
            List.of(),
            true,
            true,
            passed,
            List.of(),
            List.of(),
            List.of(),
            Optional.empty(),
            List.of(),
            null,
            null,
            List.of(),
            List.of());
    return new SimulationResult(
        List.of(verdict), null, List.of(), List.of(), Optional.empty(), signals, null);
  }

  private static final Gap TRUE = new Gap(Missing.VALUE, "true");
  private static final Gap AGAIN = new Gap(Missing.AGAIN, "a second time");

  @Test
  void eachKindOfGapIsOneFindingAndInformationOnly() {
    List<SignalCoverage> signals =
        List.of(lamp("left", AGAIN), lamp("middle"), lamp("right", TRUE), lamp("rear", TRUE));
    List<Diagnostic> found = UnshownSignals.of(result(true, signals)).findings();
    assertEquals(
        List.of(
            "value: No scenario shows /lamp.right true; /lamp.rear true.",
            "again: No scenario shows /lamp.left a second time."),
        found.stream().map(each -> each.rule() + ": " + each.message()).toList());
    for (Diagnostic each : found) {
      assertEquals("simulation.signal.unshown", each.id());
      assertEquals(Severity.INFO, each.severity());
    }
  }

  @Test
  void aFindingNamesTheFirstSignalsAndTheVerdictAll() {
    List<SignalCoverage> signals =
        IntStream.range(0, 7).mapToObj(i -> lamp("lamp" + i, TRUE)).toList();
    UnshownSignals unshown = UnshownSignals.of(result(true, signals));
    assertEquals(
        "No scenario shows /lamp.lamp0 true; /lamp.lamp1 true; /lamp.lamp2 true; /lamp.lamp3 true;"
            + " /lamp.lamp4 true; and 2 more.",
        unshown.findings().get(0).message());
    List<VerdictFile.Unshown> listed = unshown.listed().orElseThrow();
    assertEquals(7, listed.size());
    assertEquals(new VerdictFile.Unshown("/lamp.lamp6", "value", "true"), listed.get(6));
  }

  @Test
  void nothingIsSaidBesideAFailedScenario() {
    UnshownSignals unshown = UnshownSignals.of(result(false, List.of(lamp("left", TRUE))));
    assertEquals(List.of(), unshown.findings());
    assertEquals(Optional.empty(), unshown.listed());
    assertEquals(List.of(), unshown.table());
  }
}
