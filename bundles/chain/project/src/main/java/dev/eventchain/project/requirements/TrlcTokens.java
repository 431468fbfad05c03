package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The words, texts and signs of a TRLC file, with a position among them. */
final class TrlcTokens {

  private static final Pattern TOKEN =
      Pattern.compile(
          "(?<skip>\\s+|//[^\\n]*|/\\*.*?\\*/)"
              + "|(?<text>'''.*?'''|\"\"\".*?\"\"\"|\"[^\"\\\\\\n]*+(?:\\\\.[^\"\\\\\\n]*+)*+\")"
              + "|(?<word>[A-Za-z]\\w*)"
              + "|(?<number>\\d[\\w]*(?:\\.\\d+)?)"
              + "|(?<sign>\\.\\.|=>|==|!=|<=|>=|\\*\\*|[-+*/%={}\\[\\]().,:;@|<>])",
          Pattern.DOTALL);

  /** Kinds of tokens. */
  enum Kind {
    TEXT,
    WORD,
    NUMBER,
    SIGN,
    END
  }

  /**
   * A token.
   *
   * @param text what is written; of a text, what is between its quotes
   */
  record Token(Kind kind, String text, int offset) {
    boolean is(String written) {
      return kind != Kind.TEXT && text.equals(written);
    }

    boolean isWord() {
      return kind == Kind.WORD;
    }
  }

  private final SourceText source;
  private final List<Token> tokens = new ArrayList<>();
  private int next;

  TrlcTokens(SourceText source) {
    this.source = source;
    String text = source.text();
    Matcher token = TOKEN.matcher(text);
    int offset = 0;
    for (; offset < text.length(); offset = token.end()) {
      if (!token.region(offset, text.length()).lookingAt()) {
        throw refused("This is not read.", offset);
      }
      if (token.group("skip") == null) {
        tokens.add(token(token));
      }
    }
    tokens.add(new Token(Kind.END, "the end of the file", offset));
  }

  private static Token token(Matcher found) {
    if (found.group("text") != null) {
      return new Token(Kind.TEXT, unquoted(found.group()), found.start());
    }
    Kind kind =
        found.group("word") != null
            ? Kind.WORD
            : found.group("number") != null ? Kind.NUMBER : Kind.SIGN;
    return new Token(kind, found.group(), found.start());
  }

  private static String unquoted(String text) {
    return text.startsWith("'''") || text.startsWith("\"\"\"")
        ? text.substring(3, text.length() - 3)
        : text.substring(1, text.length() - 1).replace("\\\"", "\"");
  }

  Token peek() {
    return tokens.get(next);
  }

  Token peek(int ahead) {
    return tokens.get(Math.min(next + ahead, tokens.size() - 1));
  }

  Token take() {
    Token taken = peek();
    next = Math.min(next + 1, tokens.size() - 1);
    return taken;
  }

  boolean takeIf(String written) {
    boolean found = peek().is(written);
    if (found) {
      take();
    }
    return found;
  }

  void require(String written) {
    if (!takeIf(written)) {
      throw unexpected("'" + written + "'");
    }
  }

  Token requireWord() {
    if (!peek().isWord()) {
      throw unexpected("a name");
    }
    return take();
  }

  /** Takes a name that may have a package in front: {@code P.N}. */
  String requireName() {
    StringBuilder name = new StringBuilder(requireWord().text());
    while (takeIf(".")) {
      name.append('.').append(requireWord().text());
    }
    return name.toString();
  }

  /** Takes the description that may follow a name. */
  void skipText() {
    if (peek().kind() == Kind.TEXT) {
      take();
    }
  }

  /** Takes what is between brackets, with both of them. */
  void skipBlock(String opening, String closing) {
    require(opening);
    for (int depth = 1; depth > 0; ) {
      if (peek().kind() == Kind.END) {
        throw unexpected("'" + closing + "'");
      }
      Token taken = take();
      depth += taken.is(opening) ? 1 : taken.is(closing) ? -1 : 0;
    }
  }

  DiagnosticException unexpected(String wanted) {
    return refused("Here must be " + wanted + ", not '" + peek().text() + "'.", peek().offset());
  }

  private DiagnosticException refused(String message, int offset) {
    return Reading.refused(
        message, source.at(offset), "Check it with TRLC itself; what TRLC accepts is read.");
  }

  SourceLocation at(Token token) {
    return source.at(token.offset());
  }
}
