package dev.eventchain.messages;

import dev.eventchain.messages.MessageType.Constant;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The constants of a message that name values of a field: those with its type. Constants that begin
 * with the name of a field are those of this field only, as {@code POWER_SUPPLY_STATUS_FULL} is of
 * {@code power_supply_status}, and not of {@code power_supply}: the longest name counts.
 */
public final class FieldConstants {

  private FieldConstants() {}

  /** Returns the constants of a whole number or a text; none for any other field. */
  public static List<Constant> of(MessageType type, String path) {
    int dot = path.lastIndexOf('.');
    Optional<MessageType> owner =
        dot < 0
            ? Optional.of(type)
            : type.resolve(path.substring(0, dot)).type().flatMap(FieldType::message);
    return owner.map(it -> ofField(it, path.substring(dot + 1))).orElse(List.of());
  }

  private static List<Constant> ofField(MessageType message, String field) {
    Optional<FieldType> type =
        message.resolve(field).type().filter(FieldConstants::isWholeNumberOrText);
    if (type.isEmpty()) {
      return List.of();
    }
    List<Constant> alike =
        message.constants().stream().filter(it -> it.type().kind() == type.get().kind()).toList();
    List<Constant> own =
        alike.stream().filter(it -> owner(message, it).equals(Optional.of(field))).toList();
    return own.isEmpty() ? alike.stream().filter(it -> owner(message, it).isEmpty()).toList() : own;
  }

  /** Returns the field with the longest name that a constant begins with. */
  private static Optional<String> owner(MessageType message, Constant constant) {
    return message.fields().stream()
        .map(MessageType.Field::name)
        .filter(it -> constant.name().startsWith(it.toUpperCase(Locale.ROOT) + "_"))
        .max(Comparator.comparingInt(String::length));
  }

  private static boolean isWholeNumberOrText(FieldType type) {
    return type.shape() == FieldType.Shape.SINGLE
        && switch (type.kind()) {
          case BOOL, FLOAT32, FLOAT64, MESSAGE -> false;
          default -> true;
        };
  }
}
