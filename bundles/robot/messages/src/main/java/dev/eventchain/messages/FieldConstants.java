package dev.eventchain.messages;

import dev.eventchain.messages.MessageType.Constant;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;

/**
 * The constants of a message that name values of a field: those with its type. Constants that begin
 * with the name of a field are those of this field only, as {@code POWER_SUPPLY_STATUS_FULL} is of
 * {@code power_supply_status}, and not of {@code power_supply}: the longest name counts. Constants
 * that begin with no field's name are not those of a quantity, such as a limit in km/h, if a field
 * beside it has none: {@code LIMIT} names a kind of sign there.
 */
public final class FieldConstants {

  private FieldConstants() {}

  /**
   * Returns the constants of a whole number or a text; none for any other field.
   *
   * @param units gives the unit that is stated for a path, "" if the field is described without
   *     one; empty if it is not described
   */
  public static List<Constant> of(
      MessageType type, String path, Function<String, Optional<String>> units) {
    int dot = path.lastIndexOf('.');
    Optional<MessageType> owner =
        dot < 0
            ? Optional.of(type)
            : type.resolve(path.substring(0, dot)).type().flatMap(FieldType::message);
    return owner
        .map(
            it ->
                ofField(
                    it, path.substring(dot + 1), f -> units.apply(path.substring(0, dot + 1) + f)))
        .orElse(List.of());
  }

  private static List<Constant> ofField(
      MessageType message, String field, Function<String, Optional<String>> units) {
    Optional<FieldType> type =
        message.resolve(field).type().filter(FieldConstants::isWholeNumberOrText);
    if (type.isEmpty()) {
      return List.of();
    }
    List<Constant> alike =
        message.constants().stream().filter(it -> it.type().kind() == type.get().kind()).toList();
    List<Constant> own =
        alike.stream().filter(it -> owner(message, it).equals(Optional.of(field))).toList();
    if (!own.isEmpty() || isQuantityBesideOthers(message, type.get(), field, units)) {
      return own;
    }
    return alike.stream().filter(it -> owner(message, it).isEmpty()).toList();
  }

  /** Returns whether a field has a unit, and another one of its type is described without one. */
  private static boolean isQuantityBesideOthers(
      MessageType message, FieldType type, String field, Function<String, Optional<String>> units) {
    return units.apply(field).filter(it -> !it.isBlank()).isPresent()
        && message.fields().stream()
            .filter(it -> it.type().kind() == type.kind() && isWholeNumberOrText(it.type()))
            .anyMatch(it -> units.apply(it.name()).filter(String::isBlank).isPresent());
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
