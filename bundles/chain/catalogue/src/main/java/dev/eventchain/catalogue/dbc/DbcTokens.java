package dev.eventchain.catalogue.dbc;

import dev.eventchain.diagnostics.SourceText;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Tokens of a file, with a preview of two. */
final class DbcTokens {

  private static final Pattern TOKEN =
      Pattern.compile(
          "(?<word>[A-Za-z_][A-Za-z0-9_]*)"
              + "|(?<number>[-+]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][-+]?[0-9]+)?)"
              + "|(?<text>\")"
              + "|(?<sign>[^\\s])");

  /** Kind of a token. */
  enum Kind {
    WORD,
    NUMBER,
    TEXT,
    SIGN,
    END
  }

  /**
   * A token.
   *
   * @param text its characters; of a text, those between the quotation marks
   * @param offset its first character
   * @param first whether it is the first one of its line
   */
  record Token(Kind kind, String text, int offset, boolean first) {

    boolean is(String expected) {
      return kind != Kind.TEXT && text.equals(expected);
    }
  }

  /** A place where the file cannot be read. */
  static final class UnreadException extends Exception {
    private static final long serialVersionUID = 1L;
    private final int offset;

    UnreadException(String message, int offset) {
      super(message);
      this.offset = offset;
    }

    int offset() {
      return offset;
    }
  }

  private final String text;
  private final Matcher matcher;
  private int end;
  private Token next;
  private Token afterNext;

  DbcTokens(SourceText source) throws UnreadException {
    text = source.text();
    matcher = TOKEN.matcher(text);
    next = scan();
    afterNext = scan();
  }

  Token peek() {
    return next;
  }

  Token peekSecond() {
    return afterNext;
  }

  /**
   * Returns the next token, and goes on to the one after it.
   *
   * @throws UnreadException if a text does not end; then the file is at its end
   */
  Token take() throws UnreadException {
    Token taken = next;
    next = afterNext;
    afterNext = new Token(Kind.END, "", text.length(), true);
    afterNext = scan();
    return taken;
  }

  private Token scan() throws UnreadException {
    int line = end;
    if (!matcher.find(end)) {
      end = text.length();
      return new Token(Kind.END, "", end, true);
    }
    int start = matcher.start();
    boolean first = line == 0 || text.substring(line, start).indexOf('\n') >= 0;
    if (matcher.group("text") != null) {
      return text(start, first);
    }
    end = matcher.end();
    Kind kind =
        matcher.group("word") != null
            ? Kind.WORD
            : matcher.group("number") != null ? Kind.NUMBER : Kind.SIGN;
    return new Token(kind, matcher.group(), start, first);
  }

  /** Returns a text, which may have line breaks, and quotation marks after backslashes. */
  private Token text(int start, boolean first) throws UnreadException {
    int at = start + 1;
    while (at < text.length() && text.charAt(at) != '"') {
      at += text.startsWith("\\\"", at) ? 2 : 1;
    }
    if (at >= text.length()) {
      end = text.length();
      throw new UnreadException("This text does not end.", start);
    }
    end = at + 1;
    return new Token(Kind.TEXT, text.substring(start + 1, at).replace("\\\"", "\""), start, first);
  }
}
