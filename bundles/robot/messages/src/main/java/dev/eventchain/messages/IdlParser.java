package dev.eventchain.messages;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.Definition.Member;
import dev.eventchain.messages.IdlTokens.Kind;
import dev.eventchain.messages.IdlTokens.Token;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Parser for message definitions in OMG IDL 4.2, as far as ROS 2 uses it (design.ros2.org, "IDL
 * Interface Definition"). It stops at the first error or unsupported construct.
 */
final class IdlParser {

  /** The only member of a structure that stands for a message without fields (rosidl). */
  private static final String PLACEHOLDER = "structure_needs_at_least_one_member";

  private static final Pattern OCTAL = Pattern.compile("0[0-7]+");

  /** Notation of rosidl for the values of an array: a string, {@code "(1, 2)"}. */
  private static final Pattern LISTED =
      Pattern.compile("\"[(\\[](?<items>.*?),?[)\\]]\"", Pattern.DOTALL);

  private static final Set<String> CHANGE_BYTES =
      Set.of("bit_bound", "external", "mutable", "optional");

  private final String name;
  private final String ownPackage;
  private final String shortName;
  private final SourceText source;
  private final IdlTokens tokens;
  private final IdlTypes types;
  private final List<Member> fields = new ArrayList<>();
  private final List<Member> constants = new ArrayList<>();
  private final Set<String> names = new HashSet<>();
  private boolean defined;

  private IdlParser(String name, SourceText source) {
    this.name = name;
    String[] parts = name.split("/", -1);
    ownPackage = parts[0];
    shortName = parts[2];
    this.source = source;
    tokens = new IdlTokens(source);
    types = new IdlTypes(tokens, ownPackage);
  }

  /**
   * Parses one definition.
   *
   * @param name the full name of the type
   */
  static Definition parse(String name, SourceText source) {
    try {
      return new IdlParser(name, source).definition();
    } catch (DiagnosticException e) {
      return new Definition(name, List.of(), List.of(), e.diagnostics());
    }
  }

  private Definition definition() {
    while (tokens.next().kind() != Kind.END) {
      item(List.of());
    }
    if (!defined) {
      String wanted = ownPackage + "::msg::" + shortName;
      throw tokens.refusal("There is no structure " + wanted + ".", 0);
    }
    if (fields.size() == 1 && fields.get(0).name().equals(PLACEHOLDER)) {
      fields.clear();
    }
    return new Definition(name, fields, constants, List.of());
  }

  private void item(List<String> scope) {
    annotations();
    Token word = tokens.take(Kind.WORD);
    switch (word.text()) {
      case "module" -> module(scope);
      case "typedef" -> {
        require(scope.size() == 1 || scope.size() == 2, word, scope);
        typeDefinition();
      }
      case "const" -> {
        require(scope.size() == 3, word, scope);
        constant();
      }
      case "struct" -> {
        require(scope.size() == 2, word, scope);
        structure();
      }
      default -> require(false, word, scope);
    }
    tokens.take(";");
  }

  private void require(boolean condition, Token word, List<String> scope) {
    if (!condition) {
      String place = scope.isEmpty() ? "outside of modules" : "in " + String.join("::", scope);
      throw tokens.refusal(
          "'" + word.text() + "' " + place + " is not part of a message definition.",
          word.offset());
    }
  }

  private void module(List<String> scope) {
    List<String> known = List.of(ownPackage, "msg", shortName + "_Constants");
    Token word = tokens.take(Kind.WORD);
    List<String> inner = new ArrayList<>(scope);
    inner.add(word.text());
    if (inner.size() > known.size() || !inner.equals(known.subList(0, inner.size()))) {
      String wanted = String.join("::", known);
      String found = String.join("::", inner);
      throw tokens.refusal("The module " + found + " is not one of " + wanted + ".", word.offset());
    }
    tokens.take("{");
    while (!tokens.takes("}")) {
      item(inner);
    }
  }

  private void typeDefinition() {
    IdlTypes.Type type = types.read();
    do {
      Token alias = tokens.take(Kind.WORD);
      types.define(alias.text(), types.declared(type));
    } while (tokens.takes(","));
  }

  /**
   * Skips annotations, which do not affect the wire format; returns the value of {@code @default}.
   */
  private Optional<String> annotations() {
    Optional<String> value = Optional.empty();
    while (tokens.takes("@")) {
      Token annotation = tokens.take(Kind.WORD);
      boolean mutable = annotation.is("extensibility") && tokens.second().is("MUTABLE");
      if (CHANGE_BYTES.contains(annotation.text()) || mutable) {
        throw tokens.refusal(
            "@" + annotation.text() + " is not part of a message definition.", annotation.offset());
      }
      if (annotation.is("default")) {
        value = Optional.of(defaultValue());
      } else if (tokens.takes("(")) {
        skipArguments();
      }
    }
    return value;
  }

  private String defaultValue() {
    tokens.take("(");
    if (tokens.next().is("value") && tokens.second().is("=")) {
      tokens.take();
      tokens.take();
    }
    String value = value();
    tokens.take(")");
    return value;
  }

  private void skipArguments() {
    for (int depth = 1; depth > 0; ) {
      if (tokens.next().kind() == Kind.END) {
        tokens.take(")");
      }
      Token token = tokens.take();
      depth += token.is("(") ? 1 : token.is(")") ? -1 : 0;
    }
  }

  /**
   * Reads a literal and returns it in the syntax of the message language, strings quoted and
   * escaped.
   */
  private String value() {
    Token first = tokens.next();
    if (first.kind() == Kind.TEXT) {
      return Literals.quoted(tokens.text());
    }
    if (tokens.takes("-")) {
      return "-" + number();
    }
    if (tokens.takes("+") || first.kind() == Kind.NUMBER) {
      return number();
    }
    if (!first.is("TRUE") && !first.is("FALSE")) {
      throw tokens.refusal(
          "Expected a number, a string, TRUE or FALSE, not " + first.text() + ".", first.offset());
    }
    return tokens.take().text();
  }

  /**
   * Reads a number and returns it in the syntax of the message language; leading zeros make an IDL
   * integer octal.
   */
  private String number() {
    String number = tokens.take(Kind.NUMBER).text();
    return OCTAL.matcher(number).matches() ? "0o" + number.substring(1) : number;
  }

  private void constant() {
    int offset = tokens.next().offset();
    IdlTypes.Type type = types.read();
    Token constant = tokens.take(Kind.WORD);
    tokens.take("=");
    FieldType.Kind kind = type.type().kind();
    if (type.type().shape() != FieldType.Shape.SINGLE || kind == FieldType.Kind.MESSAGE) {
      throw tokens.refusal("A constant is a number, a string, TRUE or FALSE.", offset);
    }
    add(constants, constant, type, Optional.of(value()), offset);
  }

  private void structure() {
    Token word = tokens.take(Kind.WORD);
    if (!word.text().equals(shortName) || defined) {
      throw tokens.refusal(
          "The structure " + word.text() + " needs a file of its own.", word.offset());
    }
    defined = true;
    tokens.take("{");
    while (!tokens.takes("}")) {
      Optional<String> value = annotations();
      int offset = tokens.next().offset();
      IdlTypes.Type type = types.read();
      do {
        Token field = tokens.take(Kind.WORD);
        add(fields, field, types.declared(type), value, offset);
      } while (tokens.takes(","));
      tokens.take(";");
    }
  }

  private void add(
      List<Member> members, Token word, IdlTypes.Type type, Optional<String> value, int offset) {
    String member = word.text();
    if (member.startsWith("_")) {
      throw tokens.refusal("'" + member + "' cannot be the name of a field.", word.offset());
    }
    if (!names.add(member)) {
      throw tokens.refusal(
          MessageRules.NAME_DUPLICATE, "'" + member + "' is defined twice.", word.offset(), "");
    }
    Optional<Diagnostic> keyword = MemberNames.problemOfKeyword(member, source.at(word.offset()));
    if (keyword.isPresent()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, List.of(keyword.get()));
    }
    Object parsed = value.map(text -> parsed(type.type(), text, word.offset())).orElse(null);
    members.add(new Member(member, type.type(), type.base(), parsed, source.at(offset)));
  }

  private Object parsed(FieldType type, String text, int offset) {
    Matcher listed = LISTED.matcher(text);
    boolean isListed = type.shape() != FieldType.Shape.SINGLE && listed.matches();
    String value = isListed ? "[" + listed.group("items").replace("\\\"", "\"") + "]" : text;
    try {
      return Literals.parse(type, value, false);
    } catch (IllegalArgumentException e) {
      throw tokens.refusal(MessageRules.VALUE, String.valueOf(e.getMessage()), offset, "");
    }
  }
}
