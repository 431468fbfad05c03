package dev.eventchain.model;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.model.eventchain.QosProfile;
import java.util.List;
import java.util.Optional;

/**
 * A topic of the vehicle or its software, independent of any chain.
 *
 * @param topic the topic's name
 * @param messageType the type of its messages, as written
 * @param direction the role of the vehicle
 * @param qos the QoS that the vehicle offers or requests; empty if not stated
 * @param fields the described fields; the message may have more
 * @param location the location of its description
 */
public record Signal(
    String topic,
    String messageType,
    Direction direction,
    Optional<QosProfile> qos,
    List<Field> fields,
    SourceLocation location) {

  /** Role of the vehicle. */
  public enum Direction {
    /** Published by the vehicle. */
    PROVIDED,
    /** Received by the vehicle. */
    CONSUMED,
    /** Used by software only. */
    INTERNAL
  }

  /**
   * A field of the message.
   *
   * @param path its path
   * @param type its type as message definitions write it; empty if not stated
   * @param unit its unit; empty if not stated
   * @param location the location of its description
   */
  public record Field(String path, String type, String unit, SourceLocation location) {}

  /** Copies the list. */
  public Signal {
    fields = List.copyOf(fields);
  }

  /** Returns the QoS of the vehicle; the default of ROS 2 if none is stated. */
  public QosSettings quality() {
    return QosProfiles.settings(qos.orElse(null));
  }

  /** Returns the described field with a path. */
  public Optional<Field> field(String path) {
    return fields.stream().filter(field -> field.path().equals(path)).findFirst();
  }
}
