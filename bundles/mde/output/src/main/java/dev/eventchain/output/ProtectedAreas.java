package dev.eventchain.output;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Protected areas of a generated text, which users edit. An area starts at the line with {@code
 * Start of user code ID} and ends at the text {@code End of user code}.
 */
public final class ProtectedAreas {
  public static final String START = "Start of user code ";
  public static final String END = "End of user code";

  /** Suffix of a file with the lost areas of another one. */
  public static final String LOST = ".lost";

  /**
   * A protected area of a text.
   *
   * @param line the text after the start mark on its line: the id, and possibly template text such
   *     as the end of a comment
   * @param start the offset where the content starts, at the end of that line
   * @param end the offset where the content ends, before the end mark; equal to start if the area
   *     has one line only
   */
  public record Area(String line, int start, int end) {
    /** Returns the content of the area. */
    public String content(String text) {
      return text.substring(start, end);
    }
  }

  private ProtectedAreas() {}

  /** Returns the areas of a text. */
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

  /** Returns whether a content has an area. */
  public static boolean anyIn(byte[] content) {
    return new String(content, StandardCharsets.ISO_8859_1).contains(START);
  }

  /**
   * Returns the bytes outside the areas, without blanks that an editor may have left after an id.
   * The marks are ASCII, so this works for any charset that is compatible with ASCII.
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
