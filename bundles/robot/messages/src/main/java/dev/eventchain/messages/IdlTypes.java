package dev.eventchain.messages;

import dev.eventchain.messages.IdlTokens.Kind;
import dev.eventchain.messages.IdlTokens.Token;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Parser for the IDL types of messages; it knows the types renamed by {@code typedef}. */
final class IdlTypes {

  /**
   * A type; a message type is unresolved.
   *
   * @param base the full name of a message type, or the primitive type of a definition in the
   *     message language
   */
  record Type(FieldType type, String base) {}

  private static final String NO_PART = " of IDL is not part of a message definition.";
  private static final Set<String> REFUSED =
      Set.of(
          "any", "char", "enum", "fixed", "map", "native", "object", "struct", "union", "wchar",
          "wstring");
  private static final Map<String, FieldType.Kind> PRIMITIVES = primitives();

  private final IdlTokens tokens;
  private final String ownPackage;
  private final Map<String, Type> aliases = new HashMap<>();

  IdlTypes(IdlTokens tokens, String ownPackage) {
    this.tokens = tokens;
    this.ownPackage = ownPackage;
  }

  private static Map<String, FieldType.Kind> primitives() {
    Map<String, FieldType.Kind> kinds = new HashMap<>();
    kinds.put("boolean", FieldType.Kind.BOOL);
    kinds.put("octet", FieldType.Kind.BYTE);
    kinds.put("float", FieldType.Kind.FLOAT32);
    kinds.put("double", FieldType.Kind.FLOAT64);
    kinds.put("short", FieldType.Kind.INT16);
    kinds.put("long", FieldType.Kind.INT32);
    kinds.put("long long", FieldType.Kind.INT64);
    kinds.put("unsigned short", FieldType.Kind.UINT16);
    kinds.put("unsigned long", FieldType.Kind.UINT32);
    kinds.put("unsigned long long", FieldType.Kind.UINT64);
    for (FieldType.Kind kind : FieldType.Kind.values()) {
      if (kind.name().contains("INT")) {
        kinds.put(kind.name().toLowerCase(Locale.ROOT), kind);
      }
    }
    return Map.copyOf(kinds);
  }

  void define(String alias, Type type) {
    aliases.put(alias, type);
  }

  /** Reads a type, without the size that may follow a declared name. */
  Type read() {
    tokens.takes("::");
    Token first = tokens.next();
    String word = tokens.take(Kind.WORD).text();
    if (word.equals("sequence")) {
      return sequence(first);
    }
    if (word.equals("string")) {
      return single(FieldType.Kind.STRING, tokens.takes("<") ? bound() : 0);
    }
    if (REFUSED.contains(word)) {
      throw tokens.refusal("The type " + word + NO_PART, first.offset());
    }
    boolean primitive = PRIMITIVES.containsKey(word) || word.equals("unsigned");
    return primitive ? primitive(first) : named(first);
  }

  /** Returns the type of a declared name: an array if a size follows the name. */
  Type declared(Type type) {
    Type declared = type;
    while (tokens.next().is("[")) {
      Token bracket = tokens.take("[");
      declared = collection(declared, FieldType.Shape.ARRAY, size(), bracket);
      tokens.take("]");
    }
    return declared;
  }

  private Type sequence(Token first) {
    tokens.take("<");
    Type element = read();
    int size = tokens.takes(",") ? size() : 0;
    tokens.take(">");
    return collection(element, FieldType.Shape.SEQUENCE, size, first);
  }

  private Type collection(Type element, FieldType.Shape shape, int size, Token place) {
    FieldType type = element.type();
    if (type.shape() != FieldType.Shape.SINGLE) {
      throw tokens.refusal(
          "Arrays and sequences of arrays and sequences are not part of a message definition.",
          place.offset());
    }
    FieldType many = new FieldType(type.kind(), Optional.empty(), shape, size, type.stringBound());
    return new Type(many, element.base());
  }

  private int bound() {
    int bound = size();
    tokens.take(">");
    return bound;
  }

  private int size() {
    Token digits = tokens.take(Kind.NUMBER);
    if (!digits.text().matches("[1-9]\\d{0,8}")) {
      throw tokens.refusal(digits.text() + " is not a size.", digits.offset());
    }
    return Integer.parseInt(digits.text());
  }

  private Type primitive(Token first) {
    String word = first.text();
    while (PRIMITIVES.containsKey(word + " " + tokens.next().text())) {
      word += " " + tokens.take().text();
    }
    if (!PRIMITIVES.containsKey(word) || (word.equals("long") && tokens.next().is("double"))) {
      String found = word + " " + tokens.next().text();
      throw tokens.refusal("The type " + found + NO_PART, first.offset());
    }
    return single(PRIMITIVES.get(word), 0);
  }

  private static Type single(FieldType.Kind kind, int bound) {
    FieldType type = new FieldType(kind, Optional.empty(), FieldType.Shape.SINGLE, 0, bound);
    return new Type(type, kind.name().toLowerCase(Locale.ROOT));
  }

  private Type named(Token first) {
    List<String> parts = new ArrayList<>(List.of(first.text()));
    while (tokens.takes("::")) {
      parts.add(tokens.take(Kind.WORD).text());
    }
    List<String> known = List.of(ownPackage, "msg");
    List<String> scope = parts.subList(0, parts.size() - 1);
    Type alias = aliases.get(parts.get(parts.size() - 1));
    if (alias != null
        && (scope.isEmpty() || scope.equals(known) || scope.equals(known.subList(1, 2)))) {
      return alias;
    }
    List<String> full = new ArrayList<>(known.subList(0, Math.max(0, 3 - parts.size())));
    full.addAll(parts);
    String name = String.join("/", full);
    if (full.size() != 3 || !RosNames.isFullMessageType(name)) {
      throw tokens.refusal(
          "'" + String.join("::", parts) + "' is neither a primitive type nor a message type.",
          first.offset());
    }
    FieldType type =
        new FieldType(FieldType.Kind.MESSAGE, Optional.empty(), FieldType.Shape.SINGLE, 0, 0);
    return new Type(type, name);
  }
}
