package dev.eventchain.contracts;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.RosNames;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Comparison of declared types with the types of fields. */
final class DeclaredType {

  private static final Pattern TYPE =
      Pattern.compile(
          "(?<base>[A-Za-z][\\w/]*)(<=[0-9]+)?(?<array>\\[((?<bound><=)?(?<size>[0-9]{1,9}))?\\])?");

  /** Synonyms of types (OMG IDL 4.2, 7.4.1.4.4; rosidl: char is uint8, byte an octet). */
  private static final Map<String, String> SAME =
      Map.of(
          "float", "float32",
          "double", "float64",
          "boolean", "bool",
          "octet", "uint8",
          "byte", "uint8",
          "char", "uint8");

  private DeclaredType() {}

  /**
   * Returns whether the declared type fits the field. {@code float64[]} fits any array; a number in
   * the brackets must equal that of the field.
   */
  static boolean fits(String declared, FieldType field) {
    Matcher type = TYPE.matcher(declared.strip());
    return type.matches()
        && base(type.group("base")).equals(base(nameOf(field)))
        && shapeFits(type, field);
  }

  private static boolean shapeFits(Matcher type, FieldType field) {
    if (type.group("array") == null) {
      return field.shape() == FieldType.Shape.SINGLE;
    }
    if (type.group("size") == null) {
      return field.shape() != FieldType.Shape.SINGLE;
    }
    FieldType.Shape shape =
        type.group("bound") == null ? FieldType.Shape.ARRAY : FieldType.Shape.SEQUENCE;
    return field.shape() == shape && field.size() == Integer.parseInt(type.group("size"));
  }

  private static String nameOf(FieldType field) {
    return field
        .message()
        .map(MessageType::name)
        .orElseGet(() -> field.kind().name().toLowerCase(Locale.ROOT));
  }

  private static String base(String name) {
    boolean isMessage = name.indexOf('/') >= 0 || name.equals("Header");
    return isMessage ? RosNames.fullMessageType(name) : SAME.getOrDefault(name, name);
  }
}
