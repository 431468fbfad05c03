package dev.eventchain.simulation.host;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.DiagnosticException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;

/**
 * The nodes of a chain, as the world drives them, scenario after scenario. The world publishes,
 * advances time, and receives the nodes' messages. All methods throw a {@link DiagnosticException}
 * if the nodes cannot be driven any further.
 */
public interface NodeSession {

  /** A message for the topic with this index in {@code world_publishes}. */
  record Inbound(int topic, ByteBuffer message) {}

  /** A message of the nodes, its topic's index in {@code world_subscribes}, and its time in ns. */
  record Outbound(long time, int topic, ByteBuffer message) {}

  /**
   * An event that DDS reported.
   *
   * @param kind {@code deadline} for a missed one, or {@code liveliness} for a lost one
   * @param node the node of the reader
   */
  record Notice(String kind, String node, String topic, long count) {}

  /**
   * Starts fresh nodes at time 0.
   *
   * @return {@code python}, its version, and {@code warnings}, the connections that were not made
   */
  JsonNode configure(JsonNode configuration);

  /**
   * Publishes messages now and advances time.
   *
   * @param until end of the step (exclusive): events at that time belong to the next one
   * @return the messages that the nodes published meanwhile, in the order of time
   */
  List<Outbound> step(long until, List<Inbound> messages);

  /** Ends the scenario and returns the log of the nodes. */
  RunLog finish();

  /**
   * Returns the time on clocks and stamps at time 0 of the last configured scenario, in ns; 0 if
   * the nodes have no other time.
   */
  default long epoch() {
    return 0;
  }

  /**
   * Returns the largest delay of the world, or of a node at its start, behind the clock, in ns; 0
   * without real time.
   */
  default long overrun() {
    return 0;
  }

  /** Returns the deadline and liveliness events of DDS in the scenario. */
  default List<Notice> notices() {
    return List.of();
  }

  /** Returns the number of lost messages in the scenario, by topic; empty if none can be lost. */
  default Map<String, Long> lost() {
    return Map.of();
  }
}
