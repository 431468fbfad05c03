package dev.eventchain.pipeline.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.constraints.OclRules;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.ChainMeasurement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.Measurement;
import dev.eventchain.model.eventchain.NodeMeasurement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.model.eventchain.Statistics;
import dev.eventchain.ocl.evaluation.TimeBudget;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests which constraints depend on measured values. */
class MeasuredValuesTest {

  private static final EventchainFactory FACTORY = EventchainFactory.eINSTANCE;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "context ChainMeasurement inv: self.latency.maximum <= 250.0",
        "context ChainMeasurement inv: self.latency->notEmpty() implies self.latency.maximum <= 250",
        "context EventChain inv: self.measured->forAll(m | m.latency.maximum <= 250.0)",
        "context EventChain inv: ChainMeasurement.allInstances()->forAll(m | m.passed)",
        "context ChainMeasurement inv: self.measurements->select(m | m.name = 'gap')->forAll(m | m.value >= 1)",
        "context ChainMeasurement inv: self.measurements->forAll(m | m.value < 11.0 or m.value > 30.0)",
        "context SoftwareNode inv: self.measured.activations >= 7",
        "context SoftwareNode inv: self.measured->notEmpty() implies self.measured.period.maximum <= 50.0",
        "context Statistics inv: self.minimum <= self.maximum",
        "context EventChain def: slowest : Real = self.measured.latency.maximum->max()"
            + " inv: self.slowest <= 250.0",
        // Reads no measured value, so evaluation counts as a test.
        "context SoftwareNode inv: self.frequency > 0.0",
        "context ChainMeasurement inv: self.scenario <> null"
      })
  void decided(String rule) {
    assertTrue(decide(rule));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "context ChainMeasurement inv: self.latencies->forAll(l | l.latency.maximum <= 250.0)",
        "context EventChain inv: self.measured.latencies->forAll(l | l.latency.maximum <= 250.0)",
        "context EventChain inv: LatencyMeasurement.allInstances()->forAll(l | l.latency.maximum < 1)",
        "context SoftwareNode inv: self.measured.jitter->notEmpty() implies self.measured.jitter.maximum < 1",
        "context ChainMeasurement inv: self.measurements->select(m | m.name = 'gpa')->forAll(m | m.value >= 1)",
        "context ChainMeasurement inv: self.measurements->forAll(m | m.time <= 5.0 or true)",
        "context ChainMeasurement inv: self.latency.maximum >= 0.0 or self.latency.maximum < 0.0",
        "context LatencyConstraint inv: self.maximum <= 250.0 implies"
            + " Statistics.allInstances()->isEmpty() or Statistics.allInstances()->forAll(s |"
            + " s.maximum > 0)",
      })
  void notDecided(String rule) {
    assertEquals(false, decide(rule));
  }

  @Test
  void modelStaysAsItIs() {
    EventChain chain = chain();
    new MeasuredValues(chain)
        .decide(constraint("context Statistics inv: self.minimum <= self.maximum"), budget());
    assertEquals(20.0, chain.getMeasured().get(0).getLatency().getMaximum());
  }

  private static boolean decide(String rule) {
    return new MeasuredValues(chain()).decide(constraint(rule), budget());
  }

  private static TimeBudget budget() {
    return TimeBudget.of(Duration.ofMinutes(1));
  }

  private static OclConstraint constraint(String text) {
    OclRules rules =
        OclRules.parse(
            List.of(SourceText.of("rules.ocl", text)), List.of(EventchainPackage.eINSTANCE));
    assertEquals(List.of(), rules.diagnostics());
    return rules.constraints().get(0);
  }

  /** Returns a component with a period but no jitter, and a scenario with a latency and a gap. */
  private static EventChain chain() {
    EventChain chain = FACTORY.createEventChain();
    SoftwareNode node = FACTORY.createSoftwareNode();
    node.setFrequency(20);
    NodeMeasurement ofNode = FACTORY.createNodeMeasurement();
    ofNode.setActivations(7);
    ofNode.setPeriod(statistics());
    node.setMeasured(ofNode);
    chain.getSoftware().add(node);
    ChainMeasurement measured = FACTORY.createChainMeasurement();
    measured.setScenario("one");
    measured.setPassed(true);
    measured.setLatency(statistics());
    Measurement gap = FACTORY.createMeasurement();
    gap.setName("gap");
    gap.setValue(3);
    measured.getMeasurements().add(gap);
    chain.getMeasured().add(measured);
    return chain;
  }

  private static Statistics statistics() {
    Statistics statistics = FACTORY.createStatistics();
    statistics.setMinimum(10);
    statistics.setMaximum(20);
    return statistics;
  }
}
