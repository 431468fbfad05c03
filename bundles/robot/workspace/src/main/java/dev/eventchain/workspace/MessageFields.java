package dev.eventchain.workspace;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Fields of a message that hold values: each path that ends at no message of its own. */
final class MessageFields {

  /**
   * A field with its path.
   *
   * @param unit what the comment of a number names; empty if it names none
   */
  record Leaf(String path, FieldType type, Optional<String> unit) {}

  private static final Set<FieldType.Kind> NO_NUMBERS =
      Set.of(FieldType.Kind.BOOL, FieldType.Kind.STRING, FieldType.Kind.MESSAGE);

  private final FieldUnits units;

  MessageFields(MessageCatalog messages) {
    this.units = new FieldUnits(messages);
  }

  /** Returns all of them, in order. */
  List<Leaf> all(MessageType type) {
    List<Leaf> found = new ArrayList<>();
    add(type, "", found);
    return found;
  }

  private void add(MessageType type, String prefix, List<Leaf> found) {
    for (MessageType.Field field : type.fields()) {
      String path = prefix + field.name();
      FieldType kind = field.type();
      if (kind.message().isPresent() && kind.shape() == FieldType.Shape.SINGLE) {
        add(kind.message().get(), path + ".", found);
      } else {
        boolean isNumber = !NO_NUMBERS.contains(kind.kind());
        found.add(new Leaf(path, kind, isNumber ? units.of(type, field.name()) : Optional.empty()));
      }
    }
  }

  /**
   * Returns those in which paths of a source end or that they lead into; empty if a path names no
   * field, so that it is not known what the source uses.
   *
   * @param paths such as {@code twist.linear.x}, or {@code ranges.append}, which goes on behind a
   *     field
   */
  Optional<List<Leaf>> of(MessageType type, List<String> paths) {
    List<String> used = new ArrayList<>();
    for (String path : paths) {
      String field = longest(type, path);
      if (field.isEmpty()) {
        return Optional.empty();
      }
      used.add(field);
    }
    return Optional.of(
        all(type).stream().filter(leaf -> used.stream().anyMatch(it -> holds(it, leaf))).toList());
  }

  private static boolean holds(String field, Leaf leaf) {
    return leaf.path().equals(field) || leaf.path().startsWith(field + ".");
  }

  /** Returns the longest beginning of a path that is a field; empty if none is. */
  private static String longest(MessageType type, String path) {
    String part = path;
    while (!part.isEmpty() && type.resolve(part).type().isEmpty()) {
      part = withoutLast(part);
    }
    return part;
  }

  private static String withoutLast(String path) {
    return path.substring(0, Math.max(0, path.lastIndexOf('.')));
  }
}
