package dev.eventchain.ocl;

import java.util.Arrays;

/** The tokens of a text, without white space and comments. */
final class Tokens {

  private final String text;
  private int[] starts = new int[64];
  private int[] ends = new int[64];
  private int size;
  private int unclosedComment = -1;

  Tokens(String text) {
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

  /** Where a comment begins that has no end; -1 if there is none. */
  int unclosedComment() {
    return unclosedComment;
  }

  int size() {
    return size;
  }

  int start(int index) {
    return index < 0 ? 0 : starts[index];
  }

  int end(int index) {
    return ends[index];
  }

  /** The end of the token before this one; 0 if it is the first. */
  int endBefore(int index) {
    return index == 0 ? 0 : ends[index - 1];
  }

  String text(int index) {
    return text.substring(starts[index], ends[index]);
  }

  boolean is(int index, String token) {
    return index < size
        && ends[index] - starts[index] == token.length()
        && text.startsWith(token, starts[index]);
  }

  /** Whether nothing stands between a token and the one after it. */
  boolean touches(int index) {
    return index + 1 < size && ends[index] == starts[index + 1];
  }

  boolean isName(int index) {
    return index < size && Character.isJavaIdentifierStart(text.charAt(starts[index]));
  }

  /** Whether a token is a complete string literal. */
  boolean isString(int index) {
    return index < size
        && (text.charAt(starts[index]) == '\'' || text.charAt(starts[index]) == '"')
        && ends[index] - starts[index] >= 2
        && text.charAt(ends[index] - 1) == text.charAt(starts[index])
        && !isEscaped(ends[index] - 1, starts[index]);
  }

  /** Whether a backslash before a quote, which no other escapes, makes it part of the string. */
  private boolean isEscaped(int quote, int start) {
    int backslashes = 0;
    while (quote - 1 - backslashes > start && text.charAt(quote - 1 - backslashes) == '\\') {
      backslashes++;
    }
    return backslashes % 2 == 1;
  }

  /** The index of the parenthesis that closes the one at an index; {@link #size} if none does. */
  int closing(int open) {
    int depth = 0;
    for (int i = open; i < size(); i++) {
      depth += is(i, "(") ? 1 : is(i, ")") ? -1 : 0;
      if (depth == 0) {
        return i;
      }
    }
    return size();
  }
}
