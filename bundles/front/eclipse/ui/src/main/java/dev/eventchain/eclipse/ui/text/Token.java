package dev.eventchain.eclipse.ui.text;

/**
 * A piece of a text.
 *
 * @param start its first character, counted from 0
 * @param end after its last character
 */
public record Token(TokenKind kind, int start, int end) {

  /** What it reads. */
  public String of(String text) {
    return text.substring(start, end);
  }
}
