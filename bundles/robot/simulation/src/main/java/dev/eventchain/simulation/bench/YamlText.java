package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;

/** A YAML file with formulas, for the locations of problems within them. */
public record YamlText(SourceText source) {

  /**
   * Returns the range of a text in the file: the part with the same characters except white space,
   * since YAML may have folded its lines. A text with escapes is located at its start only.
   *
   * @param place the start of its value
   */
  public SourceRange range(SourceLocation place, String text) {
    String file = source.text();
    int start = source.offset(place.line(), place.column());
    if (start < file.length() && "|>".indexOf(file.charAt(start)) >= 0) {
      start = Math.max(start, file.indexOf('\n', start));
    } else if (start < file.length() && "\"'".indexOf(file.charAt(start)) >= 0) {
      start++;
    }
    int end = start;
    for (int i = 0; i < text.length(); i++) {
      if (Character.isWhitespace(text.charAt(i))) {
        continue;
      }
      while (end < file.length() && Character.isWhitespace(file.charAt(end))) {
        end++;
      }
      if (end == file.length() || file.charAt(end) != text.charAt(i)) {
        return SourceText.within(place, text).whole();
      }
      end++;
    }
    return source.range(start, end);
  }
}
