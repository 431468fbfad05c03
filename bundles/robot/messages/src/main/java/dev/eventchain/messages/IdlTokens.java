package dev.eventchain.messages;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Tokens of a file in OMG IDL 4.2. */
final class IdlTokens {

  /** Kinds of tokens. */
  enum Kind {
    /** A name or a keyword. */
    WORD,
    /** A number without a sign. */
    NUMBER,
    /** A string or character in quotes. */
    TEXT,
    /** Any other character or operator. */
    SIGN,
    /** The end of the file. */
    END
  }

  /** A token and its offset. */
  record Token(Kind kind, String text, int offset) {
    boolean is(String sign) {
      return text.equals(sign) && kind != Kind.TEXT;
    }
  }

  private static final String HINT =
      "This reads the part of IDL that rosidl writes: modules, structures, type definitions,"
          + " sequences, one-dimensional arrays, bounded strings, constants and annotations.";

  private static final Pattern TOKEN =
      Pattern.compile(
          "(?<space>\\s+|//[^\\n]*|/\\*.*?\\*/|#[ \\t]*include[^\\n]*)"
              + "|(?<text>\"(?:[^\"\\\\\\n]|\\\\.)*\")"
              + "|(?<number>\\.?\\d(?:[eE][+-]|[\\w.])*)"
              + "|(?<word>[A-Za-z_]\\w*)"
              + "|(?<sign>::|[{}()<>\\[\\]:,;=@+-])",
          Pattern.DOTALL);

  private static final Pattern ESCAPE = Pattern.compile("\\\\(.)", Pattern.DOTALL);
  private static final Map<String, String> ESCAPES =
      Map.ofEntries(
          Map.entry("n", "\n"),
          Map.entry("t", "\t"),
          Map.entry("v", "\u000b"),
          Map.entry("b", "\b"),
          Map.entry("r", "\r"),
          Map.entry("f", "\f"),
          Map.entry("a", "\u0007"),
          Map.entry("\\", "\\"),
          Map.entry("?", "?"),
          Map.entry("'", "'"),
          Map.entry("\"", "\""));

  private final SourceText source;
  private final List<Token> tokens = new ArrayList<>();
  private int position;

  /**
   * Tokenizes a file.
   *
   * @throws DiagnosticException {@code message.syntax}
   */
  IdlTokens(SourceText source) {
    this.source = source;
    String text = source.text();
    Matcher matcher = TOKEN.matcher(text);
    int offset = 0;
    while (offset < text.length()) {
      if (!matcher.region(offset, text.length()).lookingAt()) {
        String found = text.substring(offset, text.offsetByCodePoints(offset, 1));
        throw refusal("'" + found + "' is not allowed here.", offset);
      }
      for (Kind kind : List.of(Kind.TEXT, Kind.NUMBER, Kind.WORD, Kind.SIGN)) {
        if (matcher.group(kind.name().toLowerCase(java.util.Locale.ROOT)) != null) {
          tokens.add(new Token(kind, matcher.group(), offset));
        }
      }
      offset = matcher.end();
    }
    tokens.add(new Token(Kind.END, "the end of the file", text.length()));
  }

  Token next() {
    return tokens.get(position);
  }

  /** Returns the token after the next one. */
  Token second() {
    return tokens.get(Math.min(position + 1, tokens.size() - 1));
  }

  /** Takes the next token, unless it is the end. */
  Token take() {
    Token token = next();
    if (token.kind() != Kind.END) {
      position++;
    }
    return token;
  }

  Token take(Kind kind) {
    if (next().kind() != kind) {
      String wanted = kind == Kind.WORD ? "a name" : kind == Kind.NUMBER ? "a number" : "a string";
      throw refusal("Expected " + wanted + ", not " + next().text() + ".", next().offset());
    }
    return take();
  }

  Token take(String sign) {
    if (!next().is(sign)) {
      throw refusal("Expected " + sign + ", not " + next().text() + ".", next().offset());
    }
    return take();
  }

  /** Takes the next token if it is the given one. */
  boolean takes(String sign) {
    boolean found = next().is(sign);
    if (found) {
      take();
    }
    return found;
  }

  /** Takes adjacent strings as one, without quotes and escapes. */
  String text() {
    StringBuilder text = new StringBuilder();
    while (next().kind() == Kind.TEXT) {
      Token token = take();
      String quoted = token.text().substring(1, token.text().length() - 1);
      text.append(ESCAPE.matcher(quoted).replaceAll(escape -> unescaped(escape.group(1), token)));
    }
    return text.toString();
  }

  private String unescaped(String character, Token token) {
    String meant = ESCAPES.get(character);
    if (meant == null) {
      throw refusal("The escape sequence \\" + character + " is not supported.", token.offset());
    }
    return Matcher.quoteReplacement(meant);
  }

  /** Returns a finding at an offset. */
  DiagnosticException refusal(String message, int offset) {
    return refusal(MessageRules.SYNTAX, message, offset, HINT);
  }

  DiagnosticException refusal(Rule rule, String message, int offset, String hint) {
    Diagnostic problem = Diagnostic.of(rule, message, source.at(offset));
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        List.of(hint.isEmpty() ? problem : problem.withHint(hint)));
  }
}
