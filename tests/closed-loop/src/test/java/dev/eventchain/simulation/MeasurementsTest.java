package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.constraints.OclRules;
import dev.eventchain.constraints.OclValidator;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.ChainMeasurement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.Measurement;
import dev.eventchain.model.eventchain.NodeMeasurement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.model.eventchain.StatisticKind;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.xmi.XmiStore;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MeasurementsTest {

  private static final Path RULES = Path.of("src/test/resources/latency.ocl");

  @TempDir Path folder;

  private static List<Diagnostic> validate(EventChain model) {
    OclRules rules =
        OclRules.parse(List.of(SourceText.read(RULES)), List.of(EventchainPackage.eINSTANCE));
    assertEquals(List.of(), rules.diagnostics());
    return OclValidator.validate(rules, List.of(model), element -> SourceLocation.NONE)
        .diagnostics();
  }

  @Test
  void measuredModelKeepsTheDesignRuleOnTheLatency() throws Exception {
    AebProject project = new AebProject(folder);
    EventChain measured = measured(project);
    assertEquals(List.of(), validate(measured));
  }

  @Test
  void slowNodeBreaksTheDesignRuleOnTheLatency() throws Exception {
    AebProject project = new AebProject(folder);
    SoftwareNode slow = project.chain().getSoftware().get(1);
    slow.setWorstCaseExecutionTime(300);
    EventChain measured = measured(project);
    List<Diagnostic> findings = validate(measured);
    assertEquals(2, findings.size());
    assertEquals("ocl.violated", findings.get(0).id());
    assertEquals("ChainMeasurement::BrakeCommandWithin250ms", findings.get(0).rule());
    NodeMeasurement node = measured.getSoftware().get(1).getMeasured();
    assertEquals(300, node.getExecutionTime().getMinimum());
    assertTrue(node.getPeriod().getMinimum() >= 300);
    assertTrue(node.getJitter().getMinimum() >= 250);
  }

  private static EventChain measured(AebProject project) throws InterruptedException {
    List<Scenario> scenarios =
        List.of(AebProject.scenario("empty-road"), AebProject.scenario("stopped-vehicle-20"));
    return project.simulate(scenarios).measuredModel(project.chain());
  }

  @Test
  void measuredModelHoldsWhatWasMeasuredAndLeavesTheChainAlone() throws Exception {
    AebProject project = new AebProject(folder);
    byte[] before = XmiStore.toBytes(project.chain());
    EventChain measured = measured(project);
    assertArrayEquals(before, XmiStore.toBytes(project.chain()));
    assertArrayEquals(XmiStore.toBytes(measured), XmiStore.toBytes(measured(project)));

    assertEquals(2, measured.getMeasured().size());
    ChainMeasurement empty = measured.getMeasured().get(0);
    assertEquals("empty-road", empty.getScenario());
    assertTrue(empty.isPassed());
    assertEquals(Optional.empty(), find(empty, "gap", StatisticKind.MINIMUM), "nothing ahead");
    assertEquals(0, find(empty, "brake", StatisticKind.MAXIMUM).orElseThrow().getValue());
    assertEquals(measured.getSoftware().get(0), empty.getFirst());
    assertEquals(measured.getSoftware().get(3), empty.getLast());
    assertTrue(empty.getLatency().getCount() > 90);
    ChainMeasurement stopped = measured.getMeasured().get(1);
    Measurement gap = find(stopped, "gap", StatisticKind.MINIMUM).orElseThrow();
    assertTrue(gap.getValue() > 0.5);
    assertEquals("m", gap.getUnit());
    assertEquals(Optional.empty(), find(stopped, "impact.speed", StatisticKind.FINAL));
    Measurement margin = find(stopped, "no impact", StatisticKind.MARGIN).orElseThrow();
    assertEquals(gap.getValue(), margin.getValue());
    assertEquals("m", margin.getUnit());
    assertEquals(gap.getTime(), margin.getTime());

    NodeMeasurement node = measured.getSoftware().get(0).getMeasured();
    assertEquals(50, node.getPeriod().getMedian());
    assertEquals(0, node.getJitter().getMaximum());
    assertEquals(15, node.getExecutionTime().getPercentile99());
    assertEquals(stopped.getRunId(), node.getRunId());
  }

  private static Optional<Measurement> find(
      ChainMeasurement scenario, String name, StatisticKind statistic) {
    return scenario.getMeasurements().stream()
        .filter(each -> each.getName().equals(name) && each.getStatistic() == statistic)
        .findFirst();
  }

  @Test
  void numbersThatComponentsTellEachOtherAreMeasured() throws Exception {
    EventChain measured = measured(new AebProject(folder));

    String force = measured.getSoftware().get(2).getOutput().get(0).getTopicName() + ".data";
    ChainMeasurement stopped = measured.getMeasured().get(1);
    assertEquals(0.5, find(stopped, force, StatisticKind.MAXIMUM).orElseThrow().getValue());
    assertTrue(
        stopped.getMeasurements().stream().noneMatch(each -> each.getName().startsWith("/scan")),
        "what carries arrays is too much");
  }

  @Test
  void measuringAgainReplacesWhatWasMeasuredBefore() throws Exception {
    AebProject project = new AebProject(folder);
    SimulationResult result = project.simulate(List.of(AebProject.scenario("empty-road")));
    EventChain once = result.measuredModel(project.chain());
    assertArrayEquals(XmiStore.toBytes(once), XmiStore.toBytes(result.measuredModel(once)));
  }

  @Test
  void measurementsFileHasScenariosNodesAndTheHostApart() throws Exception {
    SimulationResult result =
        new AebProject(folder).simulate(List.of(AebProject.scenario("stopped-vehicle-50")));
    JsonNode json = new ObjectMapper().readTree(result.toJson());
    assertEquals(
        List.of("runId", "passed", "scenarios", "nodes", "hops", "processing", "topics", "host"),
        json.properties().stream().map(java.util.Map.Entry::getKey).toList());
    JsonNode scenario = json.get("scenarios").get(0);
    assertEquals("stopped-vehicle-50", scenario.get("name").asText());
    assertTrue(scenario.get("latency").get("maximum").asDouble() <= 250);
    JsonNode series = scenario.get("series");
    int moments = series.get("time").size();
    series.get("signals").forEach(each -> assertEquals(moments, each.get("values").size()));
    assertEquals(0.05, series.get("time").get(1).asDouble());
    JsonNode speed = null;
    for (JsonNode signal : series.get("signals")) {
      speed = signal.get("name").asText().equals("ego.speed") ? signal : speed;
    }
    assertNotNull(speed);
    assertEquals("m/s", speed.get("unit").asText());
    assertEquals(13.8889, speed.get("values").get(0).asDouble());
    assertEquals(0, speed.get("values").get(moments - 1).asDouble());
    assertEquals(4, json.get("nodes").size());
    assertFalse(json.get("nodes").get(0).has("hostExecutionTime"));
    assertTrue(
        json.get("host").get("nodes").get(0).get("hostExecutionTime").get("count").asInt() > 100);
    assertTrue(json.get("host").get("nodes").get(0).get("timesWorstCase").asDouble() > 0);
    assertFalse(json.get("host").get("confinement").asText().isEmpty());
  }

  @Test
  void hostTimeIsComparedWithTheWorstCaseOfTheModel() {
    Optional<Measurements.Statistics> five = Measurements.Statistics.of(new double[] {5});
    Optional<Measurements.Statistics> none = Measurements.Statistics.of(new double[] {0});
    Optional<Measurements.Statistics> host = Measurements.Statistics.of(new double[] {1, 20, 30});
    assertEquals(
        OptionalDouble.of(4),
        new Measurements.Node("X", 3, five, five, five, host).timesWorstCase());
    assertEquals(
        OptionalDouble.empty(),
        new Measurements.Node("X", 3, five, five, none, host).timesWorstCase());
  }

  @Test
  void percentilesAreValuesThatOccurred() {
    double[] values = new double[200];
    for (int i = 0; i < values.length; i++) {
      values[i] = 200 - i;
    }
    assertEquals(
        new Measurements.Statistics(200, 1, 100.5, 100, 198, 200),
        Measurements.Statistics.of(values).orElseThrow());
    assertTrue(Measurements.Statistics.of(new double[0]).isEmpty());
    assertEquals(
        new Measurements.Statistics(1, 7, 7, 7, 7, 7),
        Measurements.Statistics.of(new double[] {7}).orElseThrow());
  }
}
