package dev.eventchain.lsp.action;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * A value in a text in JSON.
 *
 * @param start the offset of its first character
 * @param end the offset after the last one
 * @param scalar a string, a number or a truth value; empty for objects and lists
 * @param isString true if it is a string
 * @param members those of an object, in its order; none for others
 */
record JsonSpan(
    int start, int end, Optional<String> scalar, boolean isString, Map<String, JsonSpan> members) {

  private static final JsonFactory JSON = new JsonFactory();

  /** Returns the value that begins at an offset; empty if none does, or it is broken. */
  static Optional<JsonSpan> at(String text, int offset) {
    // In a list: Jackson refuses a number that stands alone if a comma or a bracket follows it.
    String inList = "[" + text.substring(Math.min(offset, text.length()));
    try (JsonParser parser = JSON.createParser(inList)) {
      parser.nextToken();
      JsonToken first = parser.nextToken();
      boolean isNone = first == null || first == JsonToken.END_ARRAY;
      return isNone ? Optional.empty() : Optional.of(read(parser, offset - 1));
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  private static JsonSpan read(JsonParser parser, int base) throws IOException {
    int start = base + (int) parser.currentTokenLocation().getCharOffset();
    Map<String, JsonSpan> members = new LinkedHashMap<>();
    boolean isString = parser.currentToken() == JsonToken.VALUE_STRING;
    Optional<String> scalar = Optional.empty();
    if (parser.currentToken() == JsonToken.START_OBJECT) {
      while (parser.nextToken() == JsonToken.FIELD_NAME) {
        String name = parser.currentName();
        parser.nextToken();
        members.put(name, read(parser, base));
      }
    } else if (parser.currentToken() == JsonToken.START_ARRAY) {
      parser.skipChildren();
    } else {
      scalar = Optional.of(parser.getText()); // reads it to its end
    }
    int end = base + (int) parser.currentLocation().getCharOffset();
    return new JsonSpan(start, end, scalar, isString, members);
  }
}
