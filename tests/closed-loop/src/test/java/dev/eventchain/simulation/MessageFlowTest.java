package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.constraints.OclRules;
import dev.eventchain.constraints.OclValidator;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.LatencyKind;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.MessageFlow;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.ToLongFunction;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the message flow of the example, in which one scenario loses two scans. */
class MessageFlowTest {

  private static final Path RULES = Path.of("src/test/resources/hops.ocl");
  private static final String LIDAR = "/carla/ego_vehicle/lidar";
  private static final String COMMAND = "/carla/ego_vehicle/vehicle_control_cmd";

  @TempDir static Path folder;

  private static EventChain chain;
  private static SimulationResult result;
  private static MessageFlow all;

  @BeforeAll
  static void simulate() throws Exception {
    AebProject project = new AebProject(folder.resolve("usual"));
    LatencyConstraint constraint = EventchainFactory.eINSTANCE.createLatencyConstraint();
    constraint.setKind(LatencyKind.DATA_AGE);
    constraint.setFirst(project.chain().getSoftware().get(0));
    constraint.setLast(project.chain().getSoftware().get(3));
    project.chain().getLatencyConstraints().add(constraint);
    Path lost = AebProject.EXAMPLE.resolve("scenarios/lost-scan.yaml");
    chain = project.chain();
    result =
        project.simulate(
            List.of(AebProject.scenario("empty-road"), Scenario.read(lost, AebProject.BENCH)));
    all = result.measurements().flow();
  }

  private static MessageFlow.Hop hop(MessageFlow flow, String topic) {
    return flow.hops().stream()
        .filter(each -> each.topic().equals(topic))
        .findFirst()
        .orElseThrow();
  }

  private static MessageFlow.Topic topic(MessageFlow flow, String name) {
    return flow.topics().stream()
        .filter(each -> each.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void hopsLeadFromTheVehicleThroughTheComponentsToTheVehicle() {
    assertEquals(
        List.of(
            LIDAR + " from the vehicle to ObjectDetection",
            "/carla/ego_vehicle/vehicle_status from the vehicle to TTC_Calculation",
            "/scan from ObjectDetection to TTC_Calculation",
            "/aeb/time_to_collision from TTC_Calculation to Braking_Decision",
            "/vehicle/brake_force from Braking_Decision to Carla_Vehicle_Control",
            COMMAND + " from Carla_Vehicle_Control to the vehicle"),
        all.hops().stream().map(MessageFlow.Hop::words).toList());
  }

  @Test
  void figuresOfAllScenariosAreThoseOfEachTogether() {
    for (int i = 0; i < all.hops().size() - 1; i++) {
      int index = i;
      List<MessageFlow.Hop> each =
          result.verdicts().stream().map(verdict -> verdict.flow().hops().get(index)).toList();
      MessageFlow.Hop hop = all.hops().get(i);
      MessageFlow.Samples samples = hop.samples().orElseThrow();
      assertEquals(sum(each, it -> it.samples().orElseThrow().read()), samples.read());
      assertEquals(sum(each, it -> it.samples().orElseThrow().published()), samples.published());
      assertEquals(samples.read(), hop.waiting().orElseThrow().count());
      assertEquals(
          sum(each, it -> it.age().orElseThrow().count()), hop.age().orElseThrow().count());
      assertEquals(
          samples.published(), samples.read() + samples.neverRead() + samples.unreadAtEnd());
      assertTrue(samples.read() > 100, hop.toString());
    }
  }

  private static long sum(List<MessageFlow.Hop> hops, ToLongFunction<MessageFlow.Hop> count) {
    return hops.stream().mapToLong(count).sum();
  }

  @Test
  void whatTheVehicleReadsIsNotMeasured() {
    MessageFlow.Hop hop = hop(all, COMMAND);
    assertEquals(Optional.empty(), hop.waiting());
    assertEquals(Optional.empty(), hop.age());
    assertEquals(Optional.empty(), hop.samples());
    assertTrue(topic(all, COMMAND).published().orElseThrow() > 100);
  }

  @Test
  void whatTheBenchLosesIsCountedAndNotPublished() {
    assertEquals(OptionalLong.of(2), topic(all, LIDAR).dropped());
    assertEquals(OptionalLong.empty(), topic(all, "/scan").dropped(), "the bench does not send it");
    MessageFlow.Topic whole = topic(result.verdicts().get(0).flow(), LIDAR);
    assertEquals(OptionalLong.of(0), whole.dropped());
    MessageFlow gappy = result.verdicts().get(1).flow();
    assertEquals(OptionalLong.of(2), topic(gappy, LIDAR).dropped());
    assertEquals(
        topic(gappy, "/carla/ego_vehicle/vehicle_status").published().orElseThrow() - 2,
        topic(gappy, LIDAR).published().orElseThrow(),
        "both have 20 Hz");
    assertEquals(OptionalLong.of(0), topic(all, LIDAR).lost(), "nothing gets lost in lock-step");
    assertTrue(
        hop(gappy, LIDAR).age().orElseThrow().maximum()
            > hop(gappy, LIDAR).waiting().orElseThrow().maximum() + 49,
        "the scan before a lost one is used twice");
  }

  /** The parts of the slowest time are no longer than the measurements of their hops. */
  @Test
  void latenciesConsistOfHops() {
    for (ScenarioVerdict verdict : result.verdicts()) {
      ScenarioVerdict.Latency latency = verdict.latencies().get(0).orElseThrow();
      double sum = 0;
      for (ScenarioVerdict.Part part : latency.slowest()) {
        sum += part.waiting() + part.execution();
        MessageFlow flow = verdict.flow();
        assertTrue(
            flow.hops().stream()
                .filter(hop -> hop.reader().equals(part.node()))
                .anyMatch(hop -> hop.age().orElseThrow().maximum() >= part.waiting()),
            part.toString());
        assertTrue(
            flow.processing().stream()
                .filter(node -> node.node().equals(part.node()))
                .anyMatch(node -> node.time().orElseThrow().maximum() == part.execution()),
            part.toString());
      }
      assertEquals(latency.statistics().maximum(), sum, 1e-9);
    }
  }

  @Test
  void withoutANumberOfTheModelNothingIsLate() {
    all.hops().forEach(hop -> assertEquals(Optional.empty(), hop.late()));
    assertEquals(Optional.empty(), hop(all, LIDAR).tooOld());
    MessageFlow.Exceeded scan = hop(all, "/scan").tooOld().orElseThrow();
    assertEquals(250, scan.limit(), "five periods of what writes it");
    assertEquals(0, scan.times());
    assertEquals(hop(all, "/scan").age().orElseThrow().count(), scan.of());
  }

  @Test
  void constraintsReadWhatWasMeasuredOfHops() {
    OclRules rules =
        OclRules.parse(List.of(SourceText.read(RULES)), List.of(EventchainPackage.eINSTANCE));
    assertEquals(List.of(), rules.diagnostics());
    List<String> violated =
        OclValidator.validate(
                rules, List.of(result.measuredModel(chain)), it -> SourceLocation.NONE)
            .diagnostics()
            .stream()
            .map(found -> found.rule())
            .toList();
    assertEquals(List.of("ChainMeasurement::EveryScanArrives"), violated);
  }

  @Test
  void slowWriterIsLateAndItsSamplesAreTooOld() throws Exception {
    AebProject project =
        AebProject.of(
            folder.resolve("slow"),
            changed -> {
              changed.getSoftware().get(0).setWorstCaseExecutionTime(690); // a scan every 700 ms
              changed.getData().stream()
                  .filter(data -> data.getTopicName().equals("/scan"))
                  .forEach(data -> data.getQos().setDeadline(100));
            });
    SimulationResult slow = project.simulate(List.of(AebProject.scenario("empty-road")));
    MessageFlow.Hop hop = hop(slow.measurements().flow(), "/scan");
    MessageFlow.Exceeded late = hop.late().orElseThrow();
    assertEquals(new MessageFlow.Exceeded(100, late.of(), late.of()), late);
    assertEquals(hop.samples().orElseThrow().published() - 1, late.of());
    MessageFlow.Exceeded tooOld = hop.tooOld().orElseThrow();
    assertEquals(250, tooOld.limit());
    // Of 700 ms with an activation every 50 ms, those after 250 ms are too old.
    assertEquals(9.0 / 14, tooOld.times() / (double) tooOld.of(), 0.06);
    assertTrue(
        slow.diagnostics().stream()
            .anyMatch(
                found ->
                    found.id().equals("simulation.input.too-old")
                        && found.message().contains(": /scan ")
                        && found.message().endsWith(" " + tooOld.times() + " times.")));
  }
}
