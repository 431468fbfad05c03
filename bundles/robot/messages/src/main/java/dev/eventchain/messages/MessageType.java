package dev.eventchain.messages;

import dev.eventchain.diagnostics.NearestName;
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
   * @param defaultValue the value that {@link MessageValue#of} sets, represented as in {@link
   *     MessageValue}; empty for zero
   */
  public record Field(String name, FieldType type, Optional<Object> defaultValue) {}

  /**
   * A constant.
   *
   * @param value {@link Boolean}, {@link Number} or {@link String}
   */
  public record Constant(String name, FieldType type, Object value) {}

  /**
   * The result of resolving a field path.
   *
   * @param type the type of the field; empty if the path is invalid
   * @param problem the error in the path, a sentence; empty if it is valid
   * @param hint a suggestion, a sentence; empty if no name is similar
   */
  public record Resolution(Optional<FieldType> type, String problem, String hint) {}

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

  /** Returns the full name, {@code sensor_msgs/msg/LaserScan}. */
  public String name() {
    return name;
  }

  /** Returns the fields, in order. */
  public List<Field> fields() {
    return fields;
  }

  /** Returns the constants, in order. */
  public List<Constant> constants() {
    return constants;
  }

  /**
   * Returns the hash of the type as nodes of ROS 2 (Iron or later) announce it, {@code RIHS01_} and
   * 64 hexadecimal digits. Types with the same hash have the same fields, so their encodings are
   * compatible.
   */
  public String hash() {
    return TypeHash.of(this);
  }

  /** Returns the position of a field, or -1. */
  int indexOf(String field) {
    return indices.getOrDefault(field, -1);
  }

  /**
   * Resolves a path to the type of a field. A path ends at an array or sequence: their elements
   * have no path.
   */
  public Resolution resolve(String path) {
    MessageType current = this;
    int start = 0;
    while (true) {
      int dot = path.indexOf('.', start);
      String step = path.substring(start, dot < 0 ? path.length() : dot);
      int index = current.indexOf(step);
      if (index < 0) {
        return current.unknown(this, path, start, step);
      }
      FieldType type = current.fields.get(index).type();
      if (dot < 0) {
        return new Resolution(Optional.of(type), "", "");
      }
      if (type.message().isEmpty() || type.shape() != FieldType.Shape.SINGLE) {
        return new Resolution(
            Optional.empty(),
            "'" + step + "' of " + current + " is " + type + ", which has no fields.",
            "Name the whole field: " + path.substring(0, dot) + ".");
      }
      current = type.message().get();
      start = dot + 1;
    }
  }

  private Resolution unknown(MessageType root, String path, int start, String step) {
    String problem = this + " has no field '" + step + "'; it has " + names() + ".";
    String name = step.replaceFirst("\\[.*", "");
    if (name.length() < step.length() && indexOf(name) >= 0) {
      return new Resolution(
          Optional.empty(),
          problem,
          "Name the whole field, "
              + path.substring(0, start)
              + name
              + ", and pick the value inside the component.");
    }
    String rest = path.substring(start + step.length());
    // A common mistake: nav_msgs/Odometry has twist.twist.linear.x and no twist.linear.x.
    Optional<String> deeper =
        fields.stream()
            .filter(field -> field.type().message().isPresent())
            .filter(field -> field.type().message().get().indexOf(step) >= 0)
            .map(field -> path.substring(0, start) + field.name() + "." + step + rest)
            .filter(root::has)
            .findFirst();
    Optional<String> near =
        NearestName.of(step, fields.stream().map(Field::name).toList())
            .map(nearest -> path.substring(0, start) + nearest)
            .map(meant -> root.has(meant + rest) ? meant + rest : meant);
    String hint = deeper.or(() -> near).map(meant -> "Did you mean `" + meant + "`?").orElse("");
    return new Resolution(Optional.empty(), problem, hint);
  }

  private boolean has(String path) {
    Optional<MessageType> current = Optional.of(this);
    for (String step : path.split("\\.", -1)) {
      if (current.isEmpty() || current.get().indexOf(step) < 0) {
        return false;
      }
      FieldType type = current.get().fields.get(current.get().indexOf(step)).type();
      current = type.shape() == FieldType.Shape.SINGLE ? type.message() : Optional.empty();
    }
    return true;
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
