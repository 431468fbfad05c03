package dev.eventchain.editing;

/**
 * Lines that an editor can fold.
 *
 * @param firstLine the line that stays visible, from 0
 * @param lastLine the last line that is hidden, after the first
 */
public record Folding(int firstLine, int lastLine, Kind kind) {

  /** Kind of the lines. */
  public enum Kind {
    BLOCK,
    COMMENT,
    IMPORTS
  }
}
