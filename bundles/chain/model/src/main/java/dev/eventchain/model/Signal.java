package dev.eventchain.model;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.QosProfile;
import java.util.List;
import java.util.Optional;

/**
 * A topic of the vehicle or its software, independent of the chain that is built around it.
 *
 * @param topic the topic's name
 * @param messageType the type of its messages, as it was written
 * @param direction who is on the other side
 * @param qos what the vehicle offers or requests; empty if nothing is said
 * @param fields the fields that are described; the message may have more
 * @param location where it is described
 */
public record Signal(
    String topic,
    String messageType,
    Direction direction,
    Optional<QosProfile> qos,
    List<Field> fields,
    SourceLocation location) {

  /** Who is on the other side. */
  public enum Direction {
    /** The vehicle sends it. */
    PROVIDED,
    /** The vehicle receives it. */
    CONSUMED,
    /** Only software has to do with it. */
    INTERNAL
  }

  /**
   * A field of the message.
   *
   * @param path its path
   * @param type its type as message definitions write it; empty if nothing is said
   * @param unit its unit; empty if nothing is said
   * @param location where it is described
   */
  public record Field(String path, String type, String unit, SourceLocation location) {}

  /** Keeps a copy of the list. */
  public Signal {
    fields = List.copyOf(fields);
  }

  /** The described field with a path. */
  public Optional<Field> field(String path) {
    return fields.stream().filter(field -> field.path().equals(path)).findFirst();
  }
}
