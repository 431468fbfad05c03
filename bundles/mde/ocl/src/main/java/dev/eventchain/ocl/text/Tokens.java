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

  /** The tokens of a text; no text is wrong here. */
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

  /** Where a comment begins that has no end; -1 if there is none. */
  public int unclosedComment() {
    return unclosedComment;
  }

  /** How many there are. */
  public int size() {
    return size;
  }

  /** Where a token begins; 0 for what is before the first. */
  public int start(int index) {
    return index < 0 ? 0 : starts[index];
  }

  /** Where a token ends. */
  public int end(int index) {
    return ends[index];
  }

  /** The end of the token before this one; 0 if it is the first. */
  public int endBefore(int index) {
    return index == 0 ? 0 : ends[index - 1];
  }

  /** The text of a token. */
  public String text(int index) {
    return text.substring(starts[index], ends[index]);
  }

  /** Whether there is a token of this index, and it is this one. */
  public boolean is(int index, String token) {
    return index < size
        && ends[index] - starts[index] == token.length()
        && text.startsWith(token, starts[index]);
  }

  /** All of them, whatever white space and comments stand between. */
  public String words() {
    return words(0, size);
  }

  /** Some of them: from an index to before another one. */
  public String words(int from, int to) {
    StringBuilder words = new StringBuilder();
    for (int i = from; i < to; i++) {
      words.append(text(i)).append(' ');
    }
    return words.toString();
  }

  /** Whether nothing stands between a token and the one after it. */
  public boolean touches(int index) {
    return index + 1 < size && ends[index] == starts[index + 1];
  }

  /** Whether there is a token of this index, and it may be a name. */
  public boolean isName(int index) {
    return index < size && Character.isJavaIdentifierStart(text.charAt(starts[index]));
  }

  /** Whether a token is a complete string literal. */
  public boolean isString(int index) {
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
