package dev.eventchain.simulation.host;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.DiagnosticException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;

/**
 * The nodes of a chain as the world sees them, scenario after scenario: it publishes, lets time
 * pass, and gets what they published. All of it throws a {@link DiagnosticException} when the nodes
 * cannot be driven any further.
 */
public interface NodeSession {

  /** A message for the topic with this index in {@code world_publishes}. */
  record Inbound(int topic, ByteBuffer message) {}

  /**
   * A message that the nodes published, when, in ns, and on which topic of {@code
   * world_subscribes}.
   */
  record Outbound(long time, int topic, ByteBuffer message) {}

  /**
   * Something that DDS noticed.
   *
   * @param kind {@code deadline}, missed, or {@code liveliness}, lost
   * @param node the reader's
   */
  record Notice(String kind, String node, String topic, long count) {}

  /**
   * Starts with fresh nodes at time 0.
   *
   * @return what there is to say of them: {@code python}, its version, and {@code warnings}, the
   *     connections that were not made
   */
  JsonNode configure(JsonNode configuration);

  /**
   * Publishes messages now and lets time pass.
   *
   * @param until what is due then belongs to the next step
   * @return what the nodes published meanwhile, in the order of time
   */
  List<Outbound> step(long until, List<Inbound> messages);

  /** Ends the scenario; answers what the nodes did. */
  RunLog finish();

  /**
   * What clocks and stamps show at time 0 of the scenario that was configured last, in ns; 0 where
   * the nodes have no other time.
   */
  default long epoch() {
    return 0;
  }

  /**
   * How far the world, or a node at its start, fell behind the clock at most, in ns; 0 where nobody
   * follows one.
   */
  default long overrun() {
    return 0;
  }

  /** What DDS noticed of deadlines and liveliness in the scenario. */
  default List<Notice> notices() {
    return List.of();
  }

  /** How many messages got lost on the way in the scenario, by topic; none where none can. */
  default Map<String, Long> lost() {
    return Map.of();
  }
}
