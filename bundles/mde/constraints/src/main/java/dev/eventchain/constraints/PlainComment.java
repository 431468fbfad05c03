package dev.eventchain.constraints;

import dev.eventchain.diagnostics.SourceRange;
import java.util.Collection;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The text of the comment right above a clause: its lines without the annotations, and its blocks.
 * A blank line ends it; a comment after other code on its line does not belong to it.
 */
final class PlainComment {

  /** A comment, or white space. */
  private static final Pattern PIECE =
      Pattern.compile("--[^\\r\\n]*|/\\*(?s:.*?)(?:\\*/|\\z)|\\s+");

  private static final Pattern LINE_END = Pattern.compile("\\r\\n|\\r|\\n");
  private static final Pattern ANNOTATION = Pattern.compile(" ?@\\w.*");

  private final StringBuilder text = new StringBuilder();
  private boolean annotated;

  private PlainComment() {}

  /** Returns the text of the comment at the end of a part that contains only comments. */
  static String in(SourceRange part) {
    return new PlainComment().read(part);
  }

  /** Returns those ids that a text contains as a separate word, in the order given. */
  static List<String> named(String text, Collection<String> ids) {
    return ids.stream()
        .filter(
            id ->
                Pattern.compile("(?<![\\w-]|\\w[./])" + Pattern.quote(id) + "(?![\\w-]|[./]\\w)")
                    .matcher(text)
                    .find())
        .toList();
  }

  private String read(SourceRange part) {
    boolean above = part.start() == 0;
    Matcher pieces = PIECE.matcher(part.text());
    while (pieces.find()) {
      String piece = pieces.group();
      if (piece.isBlank()) {
        long lines = LINE_END.matcher(piece).results().count();
        above |= lines > 0;
        // The first line break ends a line comment.
        if (lines > 1) {
          text.setLength(0);
          annotated = false;
        }
      } else if (above) {
        add(piece);
      }
    }
    return text.toString();
  }

  private void add(String comment) {
    if (comment.startsWith("/*")) {
      annotated = false;
      text.append(comment).append('\n');
      return;
    }
    String line = comment.substring(2).stripTrailing();
    annotated = ANNOTATION.matcher(line).matches() || (annotated && line.startsWith("  "));
    if (!annotated) {
      text.append(line).append('\n');
    }
  }
}
