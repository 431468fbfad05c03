package dev.eventchain.simulation.wire;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.Durability;
import dev.eventchain.messages.QosSettings.History;
import dev.eventchain.messages.QosSettings.Liveliness;
import dev.eventchain.messages.QosSettings.Reliability;
import java.time.Duration;
import java.util.Optional;

/**
 * A writer or a reader on DDS.
 *
 * @param owner the index of its node, or {@link #WORLD}
 * @param index its position among the writers, or the readers, of its owner
 * @param topic full name in ROS 2
 * @param type full name of the message type, {@code std_msgs/msg/Float32}
 * @param qos offered by a writer, requested by a reader
 * @param guid that of DDS, as hexadecimal digits; empty for the world's and for those of others
 */
record WireEnd(int owner, int index, String topic, String type, QosSettings qos, String guid) {

  /** Owner of the world's writers and readers. */
  static final int WORLD = -1;

  /**
   * Parses the description from a host.
   *
   * @throws IllegalArgumentException if it violates the protocol
   */
  static WireEnd of(int owner, int index, JsonNode json) {
    String topic = json.required("topic").asText();
    String type = json.required("type").asText();
    return new WireEnd(owner, index, topic, type, quality(json), json.required("guid").asText());
  }

  /**
   * Parses the policies in a description; histories are kept elsewhere, so all samples are kept.
   *
   * @throws IllegalArgumentException if one is missing
   */
  static QosSettings quality(JsonNode json) {
    return new QosSettings(
        flag(json, "best_effort") ? Reliability.BEST_EFFORT : Reliability.RELIABLE,
        flag(json, "transient") ? Durability.TRANSIENT_LOCAL : Durability.VOLATILE,
        History.KEEP_ALL,
        0,
        time(json, "deadline"),
        flag(json, "manual") ? Liveliness.MANUAL_BY_TOPIC : Liveliness.AUTOMATIC,
        time(json, "lease"));
  }

  private static boolean flag(JsonNode json, String name) {
    return json.required(name).asBoolean();
  }

  /** Reads a duration; hosts write infinity as zero. */
  private static Optional<Duration> time(JsonNode json, String name) {
    return Optional.of(json.required(name).asLong())
        .filter(nanos -> nanos > 0)
        .map(Duration::ofNanos);
  }

  /** Returns whether this writer matches a reader in another process. */
  boolean feeds(WireEnd reader) {
    return owner != reader.owner()
        && topic.equals(reader.topic())
        && type.equals(reader.type())
        && QosSettings.incompatibilities(qos, reader.qos()).isEmpty();
  }

  /** Returns whether a sample on the way may be lost. */
  boolean isBestEffort() {
    return qos.reliability() == Reliability.BEST_EFFORT;
  }
}
