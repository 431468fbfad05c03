package dev.eventchain.model;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.model.eventchain.QosProfile;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

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
   * @param values the values that it may have
   * @param location the location of its description
   */
  public record Field(
      String path, String type, String unit, Values values, SourceLocation location) {

    /** Creates a field that may have any value. */
    public Field(String path, String type, String unit, SourceLocation location) {
      this(path, type, unit, Values.ANY, location);
    }
  }

  /**
   * The values that a field may have.
   *
   * @param least the least number
   * @param most the greatest number
   * @param texts the only texts; empty if all
   * @param names the names of numbers, in the order of the catalogue; a name may stand for several
   */
  public record Values(
      OptionalDouble least, OptionalDouble most, List<String> texts, List<NamedNumber> names) {

    /** All values that the type has. */
    public static final Values ANY =
        new Values(OptionalDouble.empty(), OptionalDouble.empty(), List.of());

    /** Copies the lists. */
    public Values {
      texts = List.copyOf(texts);
      names = List.copyOf(names);
    }

    /** Creates values without names. */
    public Values(OptionalDouble least, OptionalDouble most, List<String> texts) {
      this(least, most, texts, List.of());
    }

    /** Returns whether there are numbers or texts that are none of them. */
    public boolean isLimited() {
      return least.isPresent() || most.isPresent() || !texts.isEmpty();
    }

    /** Returns whether a number or a text is one of them; other values are not judged. */
    public boolean hold(Object value) {
      if (value instanceof Float number) {
        // The limit of a float is the nearest one: 0.1f is more than 0.1.
        return number >= (float) least.orElse(Double.NEGATIVE_INFINITY)
            && number <= (float) most.orElse(Double.POSITIVE_INFINITY);
      }
      if (value instanceof Number number) {
        return number.doubleValue() >= least.orElse(Double.NEGATIVE_INFINITY)
            && number.doubleValue() <= most.orElse(Double.POSITIVE_INFINITY);
      }
      return !(value instanceof String) || texts.isEmpty() || texts.contains(value);
    }
  }

  /** A number with a name, such as 3 for "Reverse". */
  public record NamedNumber(String name, double number) {}

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
