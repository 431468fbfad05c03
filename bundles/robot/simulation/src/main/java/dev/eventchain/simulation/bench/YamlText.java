package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;

/** A YAML file in which formulas stand, so that the places in them can be found. */
public record YamlText(SourceText source) {

  /**
   * Where a text is in the file, whose lines YAML may have folded: the part that has the same
   * characters but for white space. A text with escapes has none, and stands at one place.
   *
   * @param place where its value begins
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
