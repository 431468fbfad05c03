package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that values which a component delays are later than its messages. */
class ValueLatencyTest {

  private static final String DECISION = "Braking_Decision";

  @TempDir Path folder;

  private AebProject project() throws Exception {
    return AebProject.of(folder, ValueLatencyTest::constrain);
  }

  private static void constrain(EventChain chain) {
    LatencyConstraint constraint = EventchainFactory.eINSTANCE.createLatencyConstraint();
    constraint.setName("scan_to_force");
    constraint.setFirst(node(chain, "TTC_Calculation"));
    constraint.setLast(node(chain, DECISION));
    constraint.setMaximum(200);
    chain.getLatencyConstraints().add(constraint);
  }

  private static SoftwareNode node(EventChain chain, String name) {
    return chain.getSoftware().stream()
        .filter(each -> each.getName().equals(name))
        .findFirst()
        .orElseThrow();
  }

  private static ScenarioVerdict.Latency latency(SimulationResult result) {
    return result.verdicts().get(0).latencies().get(0).orElseThrow();
  }

  @Test
  void delayInAComponentIsPartOfTheLatencyOfAConstraint() throws Exception {
    List<Scenario> scenarios = List.of(AebProject.scenario("stopped-vehicle-20"));
    AebProject project = project();
    SimulationResult before = project.simulate(scenarios);
    assertEquals(0, latency(before).values());
    assertEquals(List.of(), before.diagnostics());

    Path component = project.component(DECISION);
    String source = Files.readString(component);
    String delayed =
        source.replace(
            "    def execute(self, time_to_collision):\n",
            """
                def __init__(self):
                    self._kept = [100.0] * 4

                def execute(self, time_to_collision):
                    self._kept.append(time_to_collision)
                    return self._decide(self._kept.pop(0))

                def _decide(self, time_to_collision):
            """);
    Files.writeString(component, delayed);
    SimulationResult after = project.simulate(scenarios);
    double period = 1000 / node(project.chain(), DECISION).getFrequency();
    assertEquals(4 * period, latency(after).values(), 1e-6);
    assertTrue(latency(after).statistics().minimum() >= 4 * period);
    Diagnostic finding =
        after.diagnostics().stream()
            .filter(each -> each.id().equals("simulation.value.late"))
            .findFirst()
            .orElseThrow();
    assertEquals(Severity.WARNING, finding.severity());
    assertEquals(DECISION, finding.location().element());
    assertTrue(
        finding
            .message()
            .contains(
                String.format(Locale.ROOT, "is %.0f ms from 'time_to_collision'", 4 * period)),
        finding.message());
  }
}
