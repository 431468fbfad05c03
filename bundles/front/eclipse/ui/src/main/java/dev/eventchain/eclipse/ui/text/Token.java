package dev.eventchain.eclipse.ui.text;

/**
 * A token of a text.
 *
 * @param start the offset of its first character, from 0
 * @param end the offset after its last character
 */
public record Token(TokenKind kind, int start, int end) {

  /** Returns the text of the token. */
  public String of(String text) {
    return text.substring(start, end);
  }
}
