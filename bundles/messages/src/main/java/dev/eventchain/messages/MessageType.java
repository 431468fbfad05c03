package dev.eventchain.messages;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;

/** A message type: its fields, in the order of the wire, and its constants. Immutable. */
public final class MessageType {

  /**
   * A field.
   *
   * @param defaultValue what {@link MessageValue#of} sets: of the kind that {@link MessageValue}
   *     holds; empty for zero
   */
  public record Field(String name, FieldType type, Optional<Object> defaultValue) {}

  /**
   * A constant.
   *
   * @param value {@link Boolean}, {@link Number} or {@link String}
   */
  public record Constant(String name, FieldType type, Object value) {}

  /**
   * What a field path leads to.
   *
   * @param type the type of the field; empty if there is none
   * @param problem what is wrong with the path, a sentence; empty if nothing is
   */
  public record Resolution(Optional<FieldType> type, String problem) {}

  private final String name;
  private final List<Field> fields;
  private final List<Constant> constants;
  private final Map<String, Integer> indices = new HashMap<>();

  MessageType(String name, List<Field> fields, List<Constant> constants) {
    this.name = name;
    this.fields = List.copyOf(fields);
    this.constants = List.copyOf(constants);
    for (int i = 0; i < this.fields.size(); i++) {
      indices.put(this.fields.get(i).name(), i);
    }
  }

  /** The full name, {@code sensor_msgs/msg/LaserScan}. */
  public String name() {
    return name;
  }

  /** The fields, in order. */
  public List<Field> fields() {
    return fields;
  }

  /** The constants, in order. */
  public List<Constant> constants() {
    return constants;
  }

  /** The position of a field, or -1. */
  int indexOf(String field) {
    return indices.getOrDefault(field, -1);
  }

  /** Whether the path names a field, and of which type. */
  public Resolution resolve(String path) {
    MessageType current = this;
    String rest = path;
    while (true) {
      int dot = rest.indexOf('.');
      String step = dot < 0 ? rest : rest.substring(0, dot);
      int index = current.indexOf(step);
      if (index < 0) {
        return unknown(current + " has no field '" + step + "'; it has " + current.names() + ".");
      }
      FieldType type = current.fields.get(index).type();
      if (dot < 0) {
        return new Resolution(Optional.of(type), "");
      }
      if (type.message().isEmpty() || type.shape() != FieldType.Shape.SINGLE) {
        return unknown("'" + step + "' of " + current + " is " + type + ", which has no fields.");
      }
      current = type.message().get();
      rest = rest.substring(dot + 1);
    }
  }

  private static Resolution unknown(String problem) {
    return new Resolution(Optional.empty(), problem);
  }

  private String names() {
    return fields.isEmpty()
        ? "none"
        : fields.stream().map(Field::name).collect(Collectors.joining(", "));
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof MessageType that
        && name.equals(that.name)
        && fields.equals(that.fields)
        && constants.equals(that.constants);
  }

  @Override
  public int hashCode() {
    return Objects.hash(name, fields);
  }

  @Override
  public String toString() {
    return name;
  }
}
