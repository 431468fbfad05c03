package dev.eventchain.diagnostics;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;

/** How findings are written. Findings keep the order they are given in; lines end with LF. */
public enum DiagnosticFormat {
  /** For people: file, line and column, the message, the source line with a caret, the hint. */
  TEXT {
    @Override
    public String render(List<Diagnostic> diagnostics) {
      StringBuilder text = new StringBuilder();
      for (Diagnostic diagnostic : diagnostics) {
        appendText(diagnostic, text);
      }
      return text.toString();
    }
  },
  /** For programs: an array with an object for each finding; what is unknown is left out. */
  JSON {
    @Override
    public String render(List<Diagnostic> diagnostics) {
      StringWriter text = new StringWriter();
      try (JsonGenerator json = new JsonFactory().createGenerator(text)) {
        DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
        json.setPrettyPrinter(
            new DefaultPrettyPrinter().withObjectIndenter(indenter).withArrayIndenter(indenter));
        json.writeStartArray();
        for (Diagnostic diagnostic : diagnostics) {
          writeJson(diagnostic, json);
        }
        json.writeEndArray();
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      return text + "\n";
    }
  };

  private static final int LONGEST_EXCERPT = 160;

  /** The findings in this format, ending with a line break; text of no findings is empty. */
  public abstract String render(List<Diagnostic> diagnostics);

  private static void appendText(Diagnostic diagnostic, StringBuilder text) {
    SourceLocation location = diagnostic.location();
    String place = location.toString();
    if (!place.isEmpty()) {
      text.append(place).append(": ");
    }
    text.append(diagnostic.severity()).append(": ").append(printable(diagnostic.message()));
    text.append(" [").append(diagnostic.id());
    if (!diagnostic.rule().isEmpty()) {
      text.append(' ').append(printable(diagnostic.rule()));
    }
    text.append("]\n");
    appendExcerpt(location, text);
    if (!location.element().isEmpty()) {
      text.append("  at: ").append(printable(location.element())).append('\n');
    }
    for (SourceLocation related : diagnostic.related()) {
      text.append("  see: ").append(printable(nameOf(related))).append('\n');
    }
    if (!diagnostic.hint().isEmpty()) {
      text.append("  hint: ").append(printable(diagnostic.hint())).append('\n');
    }
  }

  /** The place, or else the element where no place is known. */
  private static String nameOf(SourceLocation related) {
    return related.toString().isEmpty() ? related.element() : related.toString();
  }

  private static void appendExcerpt(SourceLocation location, StringBuilder text) {
    String excerpt = location.excerpt();
    if (excerpt.isBlank() || location.line() == 0) {
      return;
    }
    int column = Math.min(Math.max(location.column(), 1), excerpt.length() + 1) - 1;
    int from =
        Math.max(0, Math.min(column - LONGEST_EXCERPT / 2, excerpt.length() - LONGEST_EXCERPT));
    int to = Math.min(excerpt.length(), from + LONGEST_EXCERPT);
    text.append("    ").append(printable(excerpt.substring(from, to))).append('\n');
    if (location.column() > 0) {
      text.append("    ");
      for (int i = from; i < column; i++) {
        text.append(excerpt.charAt(i) == '\t' ? '\t' : ' ');
      }
      text.append("^\n");
    }
  }

  /** What comes from a model must not steer the terminal it is printed on. */
  private static String printable(String text) {
    StringBuilder result = new StringBuilder(text.length());
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '\n') {
        // What follows must not pass for a finding of its own.
        result.append("\n    ");
      } else if (c == '\t' || !(Character.isISOControl(c) || isDirection(c))) {
        result.append(c);
      } else {
        result.append('\uFFFD');
      }
    }
    return result.toString();
  }

  /** Characters that make text run the other way, so that it reads as something else. */
  private static boolean isDirection(char c) {
    return (c >= '\u202A' && c <= '\u202E')
        || (c >= '\u2066' && c <= '\u2069')
        || c == '\u200E'
        || c == '\u200F'
        || c == '\u061C';
  }

  private static void writeJson(Diagnostic diagnostic, JsonGenerator json) throws IOException {
    SourceLocation location = diagnostic.location();
    json.writeStartObject();
    json.writeStringField("id", diagnostic.id());
    json.writeStringField("severity", diagnostic.severity().toString());
    json.writeStringField("message", diagnostic.message());
    writePlace(location, json);
    writeIfKnown("hint", diagnostic.hint(), json);
    writeIfKnown("rule", diagnostic.rule(), json);
    if (!diagnostic.related().isEmpty()) {
      json.writeArrayFieldStart("related");
      for (SourceLocation related : diagnostic.related()) {
        json.writeStartObject();
        writePlace(related, json);
        json.writeEndObject();
      }
      json.writeEndArray();
    }
    json.writeEndObject();
  }

  private static void writePlace(SourceLocation location, JsonGenerator json) throws IOException {
    writeIfKnown("file", location.file(), json);
    writeIfKnown("line", location.line(), json);
    writeIfKnown("column", location.column(), json);
    writeIfKnown("element", location.element(), json);
  }

  private static void writeIfKnown(String name, String value, JsonGenerator json)
      throws IOException {
    if (!value.isEmpty()) {
      json.writeStringField(name, value);
    }
  }

  private static void writeIfKnown(String name, int value, JsonGenerator json) throws IOException {
    if (value > 0) {
      json.writeNumberField(name, value);
    }
  }
}
