package dev.eventchain.simulation.wire;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.messages.QosSettings.Durability;
import dev.eventchain.messages.QosSettings.Reliability;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Tests the matches of writers and readers, and the samples on the way. */
class WireGraphTest {

  private static final String WORLD =
      """
      {"world_publishes": [{"topic": "/scan", "type": "a/msg/S"}],
       "world_subscribes": [{"topic": "/brake", "type": "a/msg/B"}]}
      """;

  private static JsonNode json(String text) {
    try {
      return new ObjectMapper().readTree(text);
    } catch (JsonProcessingException e) {
      throw new IllegalArgumentException(e);
    }
  }

  private static String end(String topic, String type, String policies) {
    return """
    {"topic": "%s", "type": "%s", "best_effort": %s, "transient": %s, "manual": false,
     "deadline": %s, "lease": 0, "guid": "%s of %s"}
    """
        .formatted(
            topic,
            type,
            policies.contains("best effort"),
            policies.contains("transient"),
            policies.contains("deadline") ? 50_000_000 : 0,
            topic,
            type);
  }

  private static JsonNode ready(String writers, String readers) {
    return json("{\"writers\": [" + writers + "], \"readers\": [" + readers + "]}");
  }

  /** Returns the topics of a world that states its QoS. */
  private static JsonNode worldOf(String offered, String requested) {
    return json(
        "{\"world_publishes\": [%s], \"world_subscribes\": [%s]}"
            .formatted(
                stated("/scan", "a/msg/S", offered), stated("/brake", "a/msg/B", requested)));
  }

  private static String stated(String topic, String type, String policies) {
    String end = end(topic, type, policies).strip();
    String qos = "{" + end.substring(end.indexOf("\"best_effort"));
    return "{\"topic\": \"%s\", \"type\": \"%s\", \"qos\": %s}".formatted(topic, type, qos);
  }

  private static WireGraph graph(JsonNode... ready) {
    return WireGraph.of(List.of(ready), json(WORLD));
  }

  private static JsonNode connect(WireGraph graph, int node, int seconds) {
    return graph.connect(
        node,
        Duration.ofSeconds(seconds),
        end -> end.owner() == WireEnd.WORLD ? "world's " + end.topic() : end.guid());
  }

  @Test
  void theWorldOffersWhatItStatesWhateverIsRequested() {
    JsonNode ready = ready("", end("/scan", "a/msg/S", "transient, deadline"));
    WireGraph graph = WireGraph.of(List.of(ready, ready), worldOf("transient, deadline", ""));
    WireEnd world = graph.writersOf(WireEnd.WORLD).get(0);
    assertEquals(Durability.TRANSIENT_LOCAL, world.qos().durability());
    assertEquals(Optional.of(Duration.ofMillis(50)), world.qos().deadline());
    assertEquals(2, graph.sinks(world).size());
    assertEquals(0, graph.warnings().size());
    WireGraph weaker = WireGraph.of(List.of(ready), worldOf("best effort", ""));
    assertEquals(0, weaker.sinks(weaker.writersOf(WireEnd.WORLD).get(0)).size());
    assertTrue(
        weaker
            .warnings()
            .path(0)
            .path("message")
            .asText()
            .endsWith("RELIABILITY, DURABILITY, DEADLINE"),
        weaker.warnings()::toString);
  }

  @Test
  void aWorldThatStatesNothingOffersTheDefault() {
    for (String request : List.of("transient", "deadline")) {
      WireGraph graph = graph(ready("", end("/scan", "a/msg/S", request)));
      assertEquals(0, graph.sinks(graph.writersOf(WireEnd.WORLD).get(0)).size(), request);
    }
    for (String request : List.of("", "best effort")) {
      WireGraph graph = graph(ready("", end("/scan", "a/msg/S", request)));
      assertEquals(1, graph.sinks(graph.writersOf(WireEnd.WORLD).get(0)).size(), request);
    }
  }

  @Test
  void theVehicleRequestsWhatItStates() {
    JsonNode ready = ready(end("/brake", "a/msg/B", "best effort"), "");
    WireGraph reliable = WireGraph.of(List.of(ready), worldOf("", ""));
    assertEquals(List.of(), reliable.sources(reliable.readersOf(WireEnd.WORLD).get(0)));
    WireGraph weaker = WireGraph.of(List.of(ready), worldOf("", "best effort"));
    assertEquals(1, weaker.sources(weaker.readersOf(WireEnd.WORLD).get(0)).size());
  }

  @Test
  void whatIsOnlyObservedRequestsNoMoreThanAWriterOffers() {
    WireGraph graph = graph(ready(end("/brake", "a/msg/B", "best effort"), ""));
    WireEnd world = graph.readersOf(WireEnd.WORLD).get(0);
    assertEquals(Reliability.BEST_EFFORT, world.qos().reliability());
    assertEquals(1, graph.sources(world).size());
    JsonNode connect = connect(graph, 0, 3);
    assertEquals(
        json(
            "{\"writers\": [[\"world's /brake\"]], \"turns\": [[0, 1]], \"readers\": [], \"timeout_s\": 3.0}"),
        connect);
  }

  @Test
  void whatDoesNotMatchIsNotWaitedForAndSaid() {
    WireGraph graph =
        graph(
            ready(end("/gap", "a/msg/G", "best effort") + "," + end("/x", "a/msg/X", ""), ""),
            ready("", end("/gap", "a/msg/G", "") + "," + end("/x", "a/msg/Y", "")));
    assertEquals(json("[[], []]"), connect(graph, 0, 1).get("writers"));
    assertEquals(json("[[], []]"), connect(graph, 1, 1).get("readers"));
    JsonNode warnings = graph.warnings();
    assertEquals(2, warnings.size());
    assertEquals("qos.incompatible", warnings.get(0).path("id").asText());
    assertTrue(warnings.get(0).path("message").asText().endsWith("policy: RELIABILITY"));
    assertEquals("topic.type.mismatch", warnings.get(1).path("id").asText());
  }

  @Test
  void writersOnATopicTakeTurnsAndTheWorldIsFirst() {
    WireGraph graph =
        graph(
            ready(end("/scan", "a/msg/S", ""), ""),
            ready(end("/scan", "a/msg/S", ""), end("/scan", "a/msg/S", "")));
    assertEquals(json("[[1, 3]]"), connect(graph, 0, 1).get("turns"));
    assertEquals(json("[[2, 3]]"), connect(graph, 1, 1).get("turns"));
    assertEquals(
        json("[[\"/scan of a/msg/S\", \"world's /scan\"]]"),
        connect(graph, 1, 1).get("readers"),
        "what a node tells itself stays in its process");
  }

  @Test
  void aReadyFrameThatIsNoneIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> graph(json("{}")));
    assertThrows(IllegalArgumentException.class, () -> graph(ready("{\"topic\": \"/x\"}", "")));
  }

  @Test
  void onlyWhatIsUnderwayByBestEffortIsTakenForLost() {
    WireGraph graph =
        graph(
            ready(end("/gap", "a/msg/G", "best effort") + "," + end("/x", "a/msg/X", ""), ""),
            ready("", end("/gap", "a/msg/G", "best effort") + "," + end("/x", "a/msg/X", "")));
    Map<WireEnd, Long> written = new HashMap<>();
    Map<WireEnd, Long> received = new HashMap<>();
    Deliveries deliveries =
        new Deliveries(
            graph, end -> written.getOrDefault(end, 0L), end -> received.getOrDefault(end, 0L));
    assertTrue(deliveries.areComplete());
    graph.writersOf(0).forEach(writer -> written.put(writer, 3L));
    assertEquals(List.of("/gap", "/x"), deliveries.waitingTopics());
    deliveries.giveUp();
    assertEquals(List.of("/x"), deliveries.waitingTopics());
    assertEquals(Map.of("/gap", 3L), deliveries.lost());
    received.put(graph.readersOf(1).get(0), 2L);
    assertFalse(deliveries.areComplete(), "/x is still waited for");
    received.put(graph.readersOf(1).get(1), 3L);
    assertTrue(deliveries.areComplete());
    assertEquals(Map.of("/gap", 3L), deliveries.lost(), "two came after all, but too late");
    written.put(graph.writersOf(0).get(0), 4L);
    assertEquals(List.of("/gap"), deliveries.waitingTopics(), "the next one is waited for");
  }
}
