package dev.eventchain.m2t;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The parts of a generated text that belong to people. An area runs from the text {@code Start of
 * user code ID}, whose id ends with its line, to the text {@code End of user code}.
 */
final class ProtectedAreas {
  static final String START = "Start of user code ";
  static final String END = "End of user code";

  private ProtectedAreas() {}

  /** The areas of a text by id: from the end of the start's line to the start of the end mark. */
  static Map<String, String> of(String text) {
    Map<String, String> areas = new LinkedHashMap<>();
    int start = text.indexOf(START);
    while (start >= 0) {
      int idEnd = endOfLine(text, start);
      int end = text.indexOf(END, idEnd);
      if (end < 0) {
        return areas;
      }
      String id = text.substring(start + START.length(), idEnd);
      areas.putIfAbsent(id, text.substring(idEnd, end));
      start = text.indexOf(START, end);
    }
    return areas;
  }

  /** Whether a content has an area. */
  static boolean anyIn(byte[] content) {
    return new String(content, StandardCharsets.ISO_8859_1).contains(START);
  }

  /**
   * The bytes outside the areas, which a generator alone decides. The marks are ASCII, so this
   * needs no encoding for any charset that agrees with ASCII.
   */
  static byte[] withoutAreas(byte[] content) {
    String text = new String(content, StandardCharsets.ISO_8859_1);
    int start = text.indexOf(START);
    if (start < 0) {
      return content;
    }
    StringBuilder kept = new StringBuilder(text.length());
    int from = 0;
    while (start >= 0) {
      int idEnd = endOfLine(text, start);
      int end = text.indexOf(END, idEnd);
      if (end < 0) {
        break;
      }
      kept.append(text, from, idEnd);
      from = end;
      start = text.indexOf(START, end);
    }
    return kept.append(text, from, text.length()).toString().getBytes(StandardCharsets.ISO_8859_1);
  }

  private static int endOfLine(String text, int from) {
    for (int i = from; i < text.length(); i++) {
      if (text.charAt(i) == '\n' || text.charAt(i) == '\r') {
        return i;
      }
    }
    return text.length();
  }
}
