package dev.eventchain.m2t.run;

/** Tokenizer of a text, with delimiters that may change between tokens. */
public final class TokenWalk {
  private final String text;
  private int position;

  TokenWalk(String text) {
    this.text = text;
  }

  /** Returns the next token; empty after the last. */
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
