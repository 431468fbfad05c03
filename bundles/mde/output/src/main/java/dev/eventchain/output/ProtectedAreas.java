package dev.eventchain.output;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * The parts of a generated text that belong to people. An area runs from the line of the text
 * {@code Start of user code ID} to the text {@code End of user code}.
 */
public final class ProtectedAreas {
  public static final String START = "Start of user code ";
  public static final String END = "End of user code";

  /** What the name of a file ends with that has the areas which another one lost. */
  public static final String LOST = ".lost";

  /**
   * An area of a text.
   *
   * @param line what follows the start mark on its line: the id, and perhaps text of the template
   *     such as the end of a comment
   * @param start where the content starts, at the end of that line
   * @param end where the content ends, before the end mark; the start if the area has one line only
   */
  public record Area(String line, int start, int end) {
    /** What is in the area of the text that it was found in. */
    public String content(String text) {
      return text.substring(start, end);
    }
  }

  private ProtectedAreas() {}

  /** The areas of a text. */
  public static List<Area> in(String text) {
    int start = text.indexOf(START);
    if (start < 0) {
      return List.of();
    }
    List<Area> areas = new ArrayList<>();
    while (start >= 0) {
      int line = start + START.length();
      int end = text.indexOf(END, line);
      if (end < 0) {
        break;
      }
      int lineEnd = Math.min(endOfLine(text, line), end);
      areas.add(new Area(text.substring(line, lineEnd), lineEnd, end));
      start = text.indexOf(START, end);
    }
    return areas;
  }

  /** Whether a content has an area. */
  public static boolean anyIn(byte[] content) {
    return new String(content, StandardCharsets.ISO_8859_1).contains(START);
  }

  /**
   * The bytes outside the areas, which a generator alone decides, without blanks that an editor may
   * have left behind an id. The marks are ASCII, so this needs no encoding for any charset that
   * agrees with ASCII.
   */
  static byte[] withoutAreas(byte[] content) {
    String text = new String(content, StandardCharsets.ISO_8859_1);
    List<Area> areas = in(text);
    if (areas.isEmpty()) {
      return content;
    }
    StringBuilder kept = new StringBuilder(text.length());
    int from = 0;
    for (Area area : areas) {
      if (area.end() > area.start()) {
        int lineEnd = area.start();
        while (text.charAt(lineEnd - 1) == ' ' || text.charAt(lineEnd - 1) == '\t') {
          lineEnd--;
        }
        kept.append(text, from, lineEnd);
        from = area.end();
      }
    }
    return kept.append(text, from, text.length()).toString().getBytes(StandardCharsets.ISO_8859_1);
  }

  public static int endOfLine(String text, int from) {
    for (int i = from; i < text.length(); i++) {
      if (text.charAt(i) == '\n' || text.charAt(i) == '\r') {
        return i;
      }
    }
    return text.length();
  }
}
