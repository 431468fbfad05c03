package dev.eventchain.ocl.text;

import java.util.Arrays;

/**
 * The tokens of OCL text, without white space and comments: names, numbers, strings, arrows, double
 * colons, and otherwise single characters.
 */
public final class Tokens {

  private final String text;
  private int[] starts = new int[64];
  private int[] ends = new int[64];
  private int size;
  private int unclosedComment = -1;

  /** Splits a text into tokens; accepts any text. */
  public Tokens(String text) {
    this.text = text;
    for (int i = 0; i < text.length(); ) {
      int end = Lexer.end(text, i, text.length());
      if (!Lexer.isBlank(text, i)) {
        add(i, end);
      } else if (Lexer.isUnclosedComment(text, i, end)) {
        unclosedComment = i;
      }
      i = end;
    }
  }

  private void add(int start, int end) {
    if (size == starts.length) {
      starts = Arrays.copyOf(starts, size * 2);
      ends = Arrays.copyOf(ends, size * 2);
    }
    starts[size] = start;
    ends[size++] = end;
  }

  /** Returns the start of an unclosed comment; -1 if there is none. */
  public int unclosedComment() {
    return unclosedComment;
  }

  /** Returns the number of tokens. */
  public int size() {
    return size;
  }

  /** Returns the start of a token; 0 before the first. */
  public int start(int index) {
    return index < 0 ? 0 : starts[index];
  }

  /** Returns the end of a token. */
  public int end(int index) {
    return ends[index];
  }

  /** Returns the end of the token before this one; 0 if it is the first. */
  public int endBefore(int index) {
    return index == 0 ? 0 : ends[index - 1];
  }

  /** Returns the text of a token. */
  public String text(int index) {
    return text.substring(starts[index], ends[index]);
  }

  /** Returns whether the token at an index exists and has this text. */
  public boolean is(int index, String token) {
    return index < size
        && ends[index] - starts[index] == token.length()
        && text.startsWith(token, starts[index]);
  }

  /** Returns all tokens, without the white space and comments between them. */
  public String words() {
    return words(0, size);
  }

  /** Returns the tokens from an index to before another one. */
  public String words(int from, int to) {
    StringBuilder words = new StringBuilder();
    for (int i = from; i < to; i++) {
      words.append(text(i)).append(' ');
    }
    return words.toString();
  }

  /** Returns whether a token directly touches the next one. */
  public boolean touches(int index) {
    return index + 1 < size && ends[index] == starts[index + 1];
  }

  /** Returns whether the token at an index exists and may be a name. */
  public boolean isName(int index) {
    return index < size && Character.isJavaIdentifierStart(text.charAt(starts[index]));
  }

  /** Returns whether a token is a complete string literal. */
  public boolean isString(int index) {
    return index < size
        && (text.charAt(starts[index]) == '\'' || text.charAt(starts[index]) == '"')
        && ends[index] - starts[index] >= 2
        && text.charAt(ends[index] - 1) == text.charAt(starts[index])
        && !isEscaped(ends[index] - 1, starts[index]);
  }

  /** Returns whether an unescaped backslash escapes a quote. */
  private boolean isEscaped(int quote, int start) {
    int backslashes = 0;
    while (quote - 1 - backslashes > start && text.charAt(quote - 1 - backslashes) == '\\') {
      backslashes++;
    }
    return backslashes % 2 == 1;
  }

  /** Returns the index of the closing parenthesis for an opening one; {@link #size} if none. */
  public int closing(int open) {
    return closing(open, "(", ")");
  }

  /** As {@link #closing(int)} for other pairs, such as braces. */
  public int closing(int open, String opening, String closing) {
    int depth = 0;
    for (int i = open; i < size(); i++) {
      depth += is(i, opening) ? 1 : is(i, closing) ? -1 : 0;
      if (depth == 0) {
        return i;
      }
    }
    return size();
  }
}
