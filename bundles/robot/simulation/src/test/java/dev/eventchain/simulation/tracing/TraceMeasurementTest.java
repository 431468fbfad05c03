package dev.eventchain.simulation.tracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.LatencyKind;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.verdict.Measurements.Statistics;
import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;

/** Tests times in a recorded trace, and in traces by hand. */
class TraceMeasurementTest {

  private static final EventchainFactory FACTORY = EventchainFactory.eINSTANCE;

  private static SoftwareNode node(EventChain chain, String name, String in, String out) {
    SoftwareNode node = FACTORY.createSoftwareNode();
    node.setName(name);
    node.setFrequency(50);
    chain.getSoftware().add(node);
    node.getInput().add(data(chain, in));
    node.getOutput().add(data(chain, out));
    return node;
  }

  private static Data data(EventChain chain, String topic) {
    Data data = FACTORY.createData();
    data.setName("value");
    data.setTopicName(topic);
    chain.getData().add(data);
    return data;
  }

  private static EventChain chain(LatencyKind kind) {
    EventChain chain = FACTORY.createEventChain();
    LatencyConstraint constraint = FACTORY.createLatencyConstraint();
    constraint.setFirst(node(chain, "Radar_Tracking", "/radar/target", "/aeb/threat"));
    constraint.setLast(node(chain, "Brake_Request", "/aeb/threat", "/brake/request"));
    constraint.setKind(kind);
    chain.getLatencyConstraints().add(constraint);
    return chain;
  }

  private static TraceMeasurement measured(TraceText trace) {
    return TraceMeasurement.of(chain(LatencyKind.REACTION), trace.read());
  }

  /** A driver (1), which the chain does not have, and the components (2 and 3). */
  private static TraceText nodes() {
    return new TraceText()
        .node(1, "driver", "/", "", "/radar/target")
        .node(2, "radar_tracking", "/", "/radar/target", "/aeb/threat")
        .node(3, "brake_request", "/", "/aeb/threat", "/brake/request");
  }

  private static double longest(TraceMeasurement measured) {
    return measured.latencies().get(0).orElseThrow().statistics().maximum();
  }

  @Test
  void aTraceOfLttngIsMeasured() throws IOException {
    RecordedTrace trace = TraceText.read(Files.readString(RecordedTraceTest.TRACE));
    EventChain chain = chain(LatencyKind.REACTION);
    node(chain, "Collision_Warning", "/aeb/threat", "/cluster/collision_warning");
    TraceMeasurement measured = TraceMeasurement.of(chain, trace);
    assertEquals(Map.of(), measured.missing());
    assertEquals(List.of(), measured.unmatched());
    assertEquals(Map.of(), measured.outside());
    assertEquals(3, measured.components().size());
    for (TraceMeasurement.Component each : measured.components()) {
      assertEquals(6, each.times().activations());
      assertEquals(20, each.times().period().orElseThrow().median(), 0.5);
      assertTrue(each.writes());
    }
    // They sleep for 1 ms; those in Python say nothing of their callbacks.
    assertEquals(1.1, executionTime(measured, 0).orElseThrow().median(), 0.1);
    assertEquals(1.1, executionTime(measured, 1).orElseThrow().median(), 0.1);
    assertEquals(Optional.empty(), executionTime(measured, 2));
    assertEquals(3, measured.hops().size());
    measured.hops().forEach(it -> assertEquals(6, it.waiting().count()));
    // The driver publishes after 1 ms, and the brake's timer has a phase of 12 ms.
    Statistics latency = measured.latencies().get(0).orElseThrow().statistics();
    assertEquals(6, latency.count());
    assertEquals(12, latency.median(), 0.5);
  }

  private static Optional<Statistics> executionTime(TraceMeasurement measured, int component) {
    return measured.components().get(component).times().executionTime();
  }

  @Test
  void whatWasMeasuredIsInTheModel() throws IOException {
    RecordedTrace trace = TraceText.read(Files.readString(RecordedTraceTest.TRACE));
    EventChain chain = chain(LatencyKind.REACTION);
    EventChain model = TraceMeasurement.of(chain, trace).measuredModel(chain, "drive", true);
    assertEquals(6, model.getSoftware().get(1).getMeasured().getExecutionTime().getCount());
    assertEquals("drive", model.getMeasured().get(0).getScenario());
    assertTrue(model.getMeasured().get(0).isPassed());
    assertEquals(6, model.getMeasured().get(0).getLatencies().get(0).getLatency().getCount());
  }

  @Test
  void aCallbackIsBasedOnTheMessageThatItWasCalledWith() {
    TraceMeasurement measured =
        measured(
            nodes()
                .callbacks(2)
                .callbacks(3)
                .publish(1, 1, 1.01)
                .take(2, 2, 1.01)
                .start(2.1, 2, false)
                .publish(4, 2, 4.01)
                .end(4.5, 2, false)
                .take(5, 3, 4.01)
                .start(5.1, 3, false)
                .publish(6, 3, 6.01)
                .end(7, 3, false));
    assertEquals(6, longest(measured), 1e-6);
    assertEquals(2.4, executionTime(measured, 0).orElseThrow().maximum(), 1e-6);
    assertEquals(List.of(), measured.unmatched());
    assertEquals(1.1, measured.hops().get(0).waiting().maximum(), 1e-6);
  }

  /** The callback of the second message has not ended when the timer of another thread starts. */
  @Test
  void aTimerIsBasedOnMessagesThatHaveBeenHandled() {
    TraceMeasurement measured =
        measured(
            nodes()
                .callbacks(2)
                .callbacks(3)
                .publish(1, 1, 1.01)
                .in(2)
                .take(1.5, 2, 1.01)
                .start(1.6, 2, false)
                .end(1.7, 2, false)
                .in(1)
                .publish(9, 1, 9.01)
                .in(2)
                .take(9.5, 2, 9.01)
                .start(9.6, 2, false)
                .in(1)
                .start(10, 2, true)
                .in(2)
                .end(10.5, 2, false)
                .in(1)
                .publish(11, 2, 11.01)
                .end(12, 2, true)
                .take(13, 3, 11.01)
                .start(13.1, 3, false)
                .publish(14, 3, 14.01)
                .end(15, 3, false));
    assertEquals(14, longest(measured), 1e-6);
  }

  @Test
  void releasesThatRecordNoTimeOfAMessageAreMatchedByTheClock() {
    for (double stamp : new double[] {1.9, 3.1}) {
      TraceMeasurement measured =
          measured(
              nodes()
                  .callbacks(2)
                  .publish(1, 1)
                  .take(4, 2, stamp)
                  .start(4.1, 2, false)
                  .publish(5, 2)
                  .end(6, 2, false));
      assertEquals(stamp > 3 ? 1 : 0, measured.unmatched().size());
      assertEquals(stamp > 3 ? 0 : 1, measured.hops().size());
    }
  }

  @Test
  void messagesFromOutsideBeginWhenTheyWerePublishedByTheirOwnTime() {
    TraceText trace =
        new TraceText()
            .node(2, "radar_tracking", "/", "/radar/target", "/aeb/threat")
            .node(3, "brake_request", "/", "/aeb/threat", "/brake/request")
            .take(3, 2, 1)
            .publish(4, 2, 4.01)
            .take(5, 3, 4.01)
            .publish(6, 3, 6.01);
    assertEquals(Map.of("/radar/target", 1), measured(trace).outside());
    assertEquals(5, longest(measured(trace)), 1e-6);
    TraceText early = nodes().take(3, 3, 8);
    assertEquals("/aeb/threat", measured(early).unmatched().get(0).topic());
  }

  /** A message from before the trace began is no stimulus, and none that is missing. */
  @Test
  void messagesFromBeforeTheTraceAreLeftOut() {
    TraceMeasurement measured = measured(nodes().take(3, 2, -1).publish(4, 2, 4.01));
    assertEquals(List.of(), measured.unmatched());
    assertEquals(
        List.of(new TraceMeasurement.Unmatched("/radar/target", "Radar_Tracking", 1)),
        measured.earlier());
    assertEquals(Optional.empty(), measured.latencies().get(0));
  }

  /** A publisher that was not traced, and whose clock is behind, is not taken for the past. */
  @Test
  void oldTimesAreThoseOfAnotherClockOnceTheTraceHasBegun() {
    TraceMeasurement measured =
        measured(nodes().publish(1, 1, 1.01).take(2, 2, 1.01).take(999, 2, -1).take(1500, 2, -1));
    assertEquals(1, measured.earlier().get(0).count());
    assertEquals(1, measured.unmatched().get(0).count());
  }

  /** A component that starts late reads what was kept for it at once, and not again and again. */
  @Test
  void oldTimesAreThoseOfAnotherClockIfThereAreNoOthers() {
    TraceMeasurement measured =
        measured(nodes().take(5000, 2, -2).take(5001, 2, -1).take(6100, 2, -1).take(7000, 2, -1));
    assertEquals(2, measured.earlier().get(0).count());
    assertEquals(2, measured.unmatched().get(0).count());
  }

  @Test
  void messagesWithinAProcessAreNotKnown() {
    TraceMeasurement measured =
        measured(nodes().callbacks(2).start(2, 2, false).publish(3, 2, 3.01).end(4, 2, false));
    assertEquals("/radar/target", measured.unmatched().get(0).topic());
    assertEquals(1, measured.unmatched().get(0).count());
  }

  /** Without callbacks, another thread may have read anything. */
  @Test
  void messagesThatAnotherThreadTookAreNotKnown() {
    TraceMeasurement measured =
        measured(nodes().publish(1, 1, 1.01).in(7).take(2, 2, 1.01).in(8).publish(3, 2, 3.01));
    assertEquals(1, measured.unmatched().size());
    assertEquals(Optional.empty(), measured.latencies().get(0));
  }

  @Test
  void dataAgesCountEveryOutput() {
    TraceText trace =
        nodes()
            .publish(1, 1, 1.01)
            .take(2, 2, 1.01)
            .publish(3, 2, 3.01)
            .take(4, 3, 3.01)
            .publish(5, 3, 5.01)
            .publish(25, 3, 25.01);
    assertEquals(4, longest(measured(trace)), 1e-6);
    RecordedTrace read = trace.read();
    assertEquals(24, longest(TraceMeasurement.of(chain(LatencyKind.DATA_AGE), read)), 1e-6);
  }

  /** Otherwise its executions would pass for its outputs. */
  @Test
  void aComponentThatWritesNothingEndsNoLatency() {
    TraceMeasurement measured =
        measured(
            nodes()
                .callbacks(3)
                .publish(1, 1, 1.01)
                .take(2, 2, 1.01)
                .publish(3, 2, 3.01)
                .take(4, 3, 3.01)
                .start(4.1, 3, false)
                .end(5, 3, false)
                .start(6, 3, true)
                .end(7, 3, true));
    assertEquals(Optional.empty(), measured.latencies().get(0));
    assertFalse(measured.components().get(1).writes());
    assertEquals(1, measured.components().get(1).times().activations());
  }

  @Test
  void componentsAreNodesOfTheirNames() {
    TraceText trace =
        new TraceText()
            .node(1, "Radar_Tracking", "/car", "/radar/target", "/aeb/threat")
            .node(2, "brake_request", "/a", "/aeb/threat", "/brake/request")
            .node(3, "brake_request", "/b", "/aeb/threat", "/brake/request");
    TraceMeasurement measured = measured(trace);
    assertEquals("/car/Radar_Tracking", measured.components().get(0).node());
    assertEquals(
        Map.of(
            "Brake_Request",
            "several nodes are called so, and none of them alone is in the root namespace or has its topics"),
        measured.missing());
    assertEquals(
        Map.of(
            "Radar_Tracking",
            "no node is called 'radar_tracking'",
            "Brake_Request",
            "no node is called 'brake_request'"),
        measured(new TraceText()).missing());
  }

  /** As init calls the nodes of a workspace: the second one by its namespace, too. */
  @Test
  void nodesOfNamespacesAreTheComponentsWithTheirTopics() {
    EventChain chain = FACTORY.createEventChain();
    node(chain, "Range_Driver", "/front/echo", "/front/range");
    node(chain, "Rear_Range_Driver", "/rear/echo", "/rear/range");
    TraceMeasurement measured =
        TraceMeasurement.of(
            chain,
            new TraceText()
                .node(1, "range_driver", "/rear", "/rear/echo", "/rear/range")
                .node(2, "range_driver", "/front", "/front/echo", "/front/range")
                .read());
    assertEquals(
        List.of("/front/range_driver", "/rear/range_driver"),
        measured.components().stream().map(TraceMeasurement.Component::node).toList());
  }

  /** Two processes with the same ids, each executing a callback at the same time. */
  private static TraceText overlapping(UnaryOperator<TraceText> second) {
    TraceText trace =
        nodes()
            .callbacks(2)
            .publish(1, 1, 1.01)
            .take(2, 2, 1.01)
            .start(2.1, 2, false)
            .publish(4, 2, 4.01);
    TraceText both = second.apply(trace).node(4, "other", "/", "/x", "").callbacks(4);
    return both.start(4.2, 4, false).back().end(4.5, 2, false);
  }

  @Test
  void processesOfSeveralContainersMayHaveTheSameIds() {
    for (UnaryOperator<TraceText> other :
        List.<UnaryOperator<TraceText>>of(it -> it.inside(4_026_532_001L), it -> it.on(1, "b"))) {
      TraceText trace = overlapping(other);
      assertEquals(List.of(), trace.read().mixed());
    }
    assertEquals(List.of("vpid 16022, vtid 1"), overlapping(it -> it).read().mixed());
  }

  @Test
  void messagesThatAreNeverAnsweredAreCounted() {
    TraceText trace =
        answered(1)
            // The second message is skipped, the third one answered, and the last two are not.
            .publish(21, 1, 21.01)
            .publish(41, 1, 41.01)
            .take(42, 2, 41.01)
            .publish(43, 2, 43.01)
            .take(44, 3, 43.01)
            .publish(45, 3, 45.01)
            .publish(61, 1, 61.01)
            .publish(81, 1, 81.01)
            .take(82, 2, 81.01);
    TraceMeasurement measured = measured(trace);
    assertEquals(4, longest(measured), 1e-6);
    TraceMeasurement.Unanswered found = measured.unanswered().get(0);
    assertEquals(3, found.count());
    assertEquals(24, found.untilLater(), 1e-6);
    assertEquals(21, found.untilEnd(), 1e-6);
    assertEquals(24, found.longest(), 1e-6);
  }

  /** Components that are not there yet answer nothing, and are not late. */
  @Test
  void messagesBeforeTheFirstAnswerAreNotMissed() {
    TraceText trace = nodes().publish(1, 1, 1.01).publish(21, 1, 21.01);
    assertEquals(0, measured(trace).unanswered().get(0).count());
    TraceText later = trace.publish(41, 1, 41.01).take(42, 2, 41.01).publish(43, 2, 43.01);
    TraceMeasurement all = measured(later.take(44, 3, 43.01).publish(45, 3, 45.01));
    assertEquals(0, all.unanswered().get(0).count());
    assertEquals(0, all.unanswered().get(0).longest());
  }

  /** A message that passes through both components in 4 ms. */
  private static TraceText answered(double time) {
    return nodes()
        .publish(time, 1, time + 0.01)
        .take(time + 1, 2, time + 0.01)
        .publish(time + 2, 2, time + 2.01)
        .take(time + 3, 3, time + 2.01)
        .publish(time + 4, 3, time + 4.01);
  }
}
