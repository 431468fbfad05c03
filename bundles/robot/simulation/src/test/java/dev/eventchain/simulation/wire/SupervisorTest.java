package dev.eventchain.simulation.wire;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.simulation.host.UserFiles;
import dev.eventchain.simulation.wire.NodeProcess.Said;
import dev.eventchain.simulation.wire.Supervisor.Watched;
import dev.eventchain.simulation.wire.WireWorld.Arrived;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** Tests the blamed node when nothing continues, with a clock that the test sets. */
class SupervisorTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final long NOW = 1_500_000_000L;
  private static final Said SAID = new Said(null, null, "");
  private static final Arrived SAMPLE = new Arrived(0, null);

  private static final class Node implements Watched {
    private final String name;
    private boolean isIdle = true;
    private boolean isStopped;

    Node(String name) {
      this.name = name;
    }

    @Override
    public String name() {
      return name;
    }

    @Override
    public boolean isIdle() {
      return isIdle;
    }

    @Override
    public boolean isStopped() {
      return isStopped;
    }
  }

  private final Node radar = new Node("Radar");
  private final Node brake = new Node("Brake");
  private long clock;
  private final Supervisor supervisor =
      new Supervisor(
          List.of(radar, brake), new UserFiles(Path.of("package")), PATIENCE, () -> clock);

  private Deliveries underway = oneUnderway(true);

  /**
   * Returns deliveries with a message from the radar to the brake that was written and not
   * received.
   */
  private static Deliveries oneUnderway(boolean bestEffort) {
    String end =
        """
        {"topic": "/gap", "type": "a/msg/G", "best_effort": %s, "transient": false,
         "manual": false, "deadline": 0, "lease": 0, "guid": "1"}
        """
            .formatted(bestEffort);
    List<JsonNode> ready = List.of(ready(end, ""), ready("", end));
    return new Deliveries(
        WireGraph.of(ready, JsonNodeFactory.instance.objectNode()),
        writer -> writer.topic().equals("/gap") ? 1 : 0,
        reader -> 0);
  }

  private static JsonNode ready(String writers, String readers) {
    try {
      return new ObjectMapper()
          .readTree("{\"writers\": [" + writers + "], \"readers\": [" + readers + "]}");
    } catch (JsonProcessingException e) {
      throw new IllegalArgumentException(e);
    }
  }

  private Optional<Object> after(long seconds) {
    clock += TimeUnit.SECONDS.toNanos(seconds);
    return supervisor.await(NOW, Optional.of(underway));
  }

  private Diagnostic blamedAfter(long seconds) {
    return assertThrows(DiagnosticException.class, () -> after(seconds)).diagnostics().get(0);
  }

  @Test
  void aNodeThatWasStoppedIsNamedSoon() {
    brake.isStopped = true;
    assertEquals(Optional.empty(), after(1));
    Diagnostic found = blamedAfter(1);
    assertEquals("simulation.node.lost", found.id());
    assertTrue(found.message().startsWith("Node Brake was stopped 1.500 s into"), found::message);
  }

  @Test
  void aNodeThatOwesAnAnswerIsNamedAfterTheTime() {
    brake.isIdle = false;
    assertEquals(Optional.empty(), after(30));
    Diagnostic found = blamedAfter(1);
    assertEquals("simulation.node.lost", found.id());
    assertTrue(found.message().startsWith("Node Brake did not answer within 30 s"), found::message);
  }

  @Test
  void samplesOfOthersAreNoSignOfLife() {
    brake.isIdle = false;
    for (int second = 0; second < 30; second += 10) {
      supervisor.arrived(SAMPLE);
      assertEquals(Optional.of(SAMPLE), after(10));
    }
    supervisor.arrived(SAMPLE);
    assertEquals("simulation.node.lost", blamedAfter(1).id());
  }

  @Test
  void aNodeThatSaysSomethingIsNotBlamed() {
    brake.isIdle = false;
    for (int second = 0; second < 90; second += 30) {
      supervisor.said(SAID);
      assertEquals(Optional.of(SAID), after(30));
    }
  }

  @Test
  void whatBestEffortLosesIsGivenUpOnlyWhenAllAreStill() {
    brake.isIdle = false;
    after(21);
    assertEquals(Map.of(), underway.lost(), "a node may still take it");
    brake.isIdle = true;
    supervisor.arrived(SAMPLE);
    after(1);
    assertEquals(Map.of(), underway.lost(), "something arrives");
    after(21);
    assertEquals(Map.of("/gap", 1L), underway.lost());
    assertTrue(underway.areComplete());
  }

  @Test
  void messagesThatDoNotArriveAreNamedByTheirTopic() {
    underway = oneUnderway(false);
    Diagnostic found = blamedAfter(31);
    assertEquals("simulation.node.lost", found.id());
    assertEquals("Messages do not arrive, 1.500 s into the scenario: /gap.", found.message());
  }

  @Test
  void inRealTimeSilenceIsNobodysFaultButOfWhoWasStopped() {
    clock += TimeUnit.MINUTES.toNanos(10);
    assertEquals(Optional.empty(), supervisor.await(NOW, Duration.ofMillis(1)));
    radar.isStopped = true;
    clock += TimeUnit.SECONDS.toNanos(2);
    Diagnostic found =
        assertThrows(DiagnosticException.class, () -> supervisor.await(NOW, Duration.ofMillis(1)))
            .diagnostics()
            .get(0);
    assertTrue(found.message().startsWith("Node Radar was stopped"), found::message);
  }

  @Test
  void aNewScenarioForgetsTheSamplesOfTheOneBeforeAndItsSilence() {
    brake.isIdle = false;
    supervisor.arrived(SAMPLE);
    clock += TimeUnit.MINUTES.toNanos(10);
    supervisor.start();
    assertEquals(Optional.empty(), after(1));
  }
}
