package dev.eventchain.m2t.run;

/** A walk through the tokens of a text, whose delimiters may change on the way. */
public final class TokenWalk {
  private final String text;
  private int position;

  TokenWalk(String text) {
    this.text = text;
  }

  /** The next token; empty after the last. */
  public String next(String delimiters) {
    while (position < text.length() && delimiters.indexOf(text.charAt(position)) >= 0) {
      position++;
    }
    int start = position;
    while (position < text.length() && delimiters.indexOf(text.charAt(position)) < 0) {
      position++;
    }
    return text.substring(start, position);
  }
}
