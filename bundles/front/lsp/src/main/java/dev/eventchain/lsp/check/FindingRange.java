package dev.eventchain.lsp.check;

import dev.eventchain.diagnostics.SourceLocation;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;

/**
 * The part of a line that a finding marks: the word at its place, the rest of the line if there is
 * only a sign such as that of a list, or else the whole line.
 */
final class FindingRange {

  private FindingRange() {}

  /**
   * Returns the range of a place.
   *
   * @param marked true if the editor counts a byte order mark as the first character
   */
  static Range of(SourceLocation place, boolean marked) {
    if (place.line() < 1) {
      return new Range(new Position(0, 0), new Position(0, 0));
    }
    String line = place.excerpt();
    int start =
        place.column() > 0 ? place.column() - 1 : line.length() - line.stripLeading().length();
    int end = place.column() > 0 ? endOfWord(line, start) : line.length();
    int shift = marked && place.line() == 1 ? 1 : 0;
    return new Range(
        new Position(place.line() - 1, start + shift),
        new Position(place.line() - 1, Math.max(start, end) + shift));
  }

  /** Returns the end of the name, start tag or text at an offset; of the line if there is none. */
  private static int endOfWord(String line, int from) {
    int end = from;
    if (end < line.length() && line.charAt(end) == '<') {
      end++;
    }
    while (end < line.length() && isPart(line.charAt(end))) {
      end++;
    }
    while (end > from + 1 && "./:-".indexOf(line.charAt(end - 1)) >= 0) {
      end--;
    }
    boolean isWord =
        end > from && line.substring(from, end).chars().anyMatch(Character::isLetterOrDigit);
    return isWord ? end : line.length();
  }

  private static boolean isPart(char c) {
    return Character.isLetterOrDigit(c) || "_:.-/@".indexOf(c) >= 0;
  }
}
