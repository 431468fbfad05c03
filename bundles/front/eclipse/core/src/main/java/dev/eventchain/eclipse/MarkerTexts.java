package dev.eventchain.eclipse;

import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.resources.IResource;

/** Converts lines and columns to character offsets for text editors. */
final class MarkerTexts {

  private final Map<IResource, Optional<Lines>> read = new HashMap<>();

  /** A text with the offsets of its lines and of its end. */
  private record Lines(String text, List<Integer> starts) {

    static Lines of(String text) {
      List<Integer> starts = new ArrayList<>(List.of(0));
      for (int i = 0; i < text.length(); i++) {
        char c = text.charAt(i);
        boolean first = c == '\r' && i + 1 < text.length() && text.charAt(i + 1) == '\n';
        if (c == '\n' || (c == '\r' && !first)) {
          starts.add(i + 1);
        }
      }
      return new Lines(text, starts);
    }

    /** Returns the offset of a column in characters, at most the end of the line. */
    int offset(int line, int column) {
      int start = starts.get(line - 1);
      int end = end(line);
      int offset = start;
      for (int i = 1; i < column && offset < end; i++) {
        offset += Character.charCount(text.codePointAt(offset));
      }
      return Math.min(offset, end);
    }

    /** Returns the offset after the last character of a line that is not a line break. */
    int end(int line) {
      int end = line < starts.size() ? starts.get(line) : text.length();
      while (end > starts.get(line - 1) && "\r\n".indexOf(text.charAt(end - 1)) >= 0) {
        end--;
      }
      return end;
    }

    /** Returns the end of the name, start tag or text at an offset. */
    int endOfToken(int from, int endOfLine) {
      int end = from;
      if (end < endOfLine && text.charAt(end) == '<') {
        end++;
      }
      while (end < endOfLine && (Character.isLetterOrDigit(text.charAt(end)) || isPart(end))) {
        end++;
      }
      return end > from ? end : endOfLine;
    }

    private boolean isPart(int offset) {
      return "_:.-/@".indexOf(text.charAt(offset)) >= 0;
    }
  }

  /** Adds the character range of a location, if the file still has that line. */
  void addRange(IResource file, SourceLocation place, Map<String, Object> attributes) {
    Optional<Lines> lines = read.computeIfAbsent(file, MarkerTexts::read);
    if (lines.isEmpty() || place.line() > lines.get().starts().size()) {
      return;
    }
    Lines text = lines.get();
    int start = text.offset(place.line(), Math.max(1, place.column()));
    int endOfLine = text.end(place.line());
    attributes.put(IMarker.CHAR_START, start);
    attributes.put(
        IMarker.CHAR_END, place.column() > 0 ? text.endOfToken(start, endOfLine) : endOfLine);
  }

  private static Optional<Lines> read(IResource file) {
    return CheckedFiles.pathOf(file)
        .flatMap(
            path -> {
              try {
                return Optional.of(Lines.of(Files.readString(path, StandardCharsets.UTF_8)));
              } catch (IOException e) {
                return Optional.empty(); // deleted or not text: the line alone is used
              }
            });
  }
}
