package dev.eventchain.lsp.project;

import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextLines;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The objects with names in JSON, in each other; also of a text that is half typed. */
final class JsonOutline {

  /** Keys by which our files name objects: components, values, topics and their fields. */
  private static final Map<String, ElementKind> NAMES =
      Map.of(
          "name", ElementKind.CLASS,
          "Topic Name", ElementKind.CLASS,
          "topic", ElementKind.REFERENCE,
          "Field", ElementKind.ATTRIBUTE,
          "id", ElementKind.CLASS);

  private static final int MOST = 10_000;

  private static final Pattern TOKEN =
      Pattern.compile(
          "\"((?:[^\"\\\\\\n]++|\\\\.)*+)\"(?:\\s*:\\s*\"((?:[^\"\\\\\\n]++|\\\\.)*+)\")?|[{}]");

  /** An object. */
  private static final class Part {
    private final int start;
    private final List<Symbol> parts = new ArrayList<>();
    private String name = "";
    private ElementKind kind = ElementKind.CLASS;
    private int nameStart;

    Part(int start) {
      this.start = start;
    }
  }

  private final TextLines lines;
  private final List<Symbol> all = new ArrayList<>();
  private final Deque<Part> open = new ArrayDeque<>();

  private JsonOutline(TextLines lines) {
    this.lines = lines;
  }

  /** Returns the objects of a text in its order. */
  static List<Symbol> of(String text, TextLines lines) {
    JsonOutline outline = new JsonOutline(lines);
    Matcher token = TOKEN.matcher(text);
    for (int i = 0; token.find(); i++) {
      if (i > MOST) {
        break;
      }
      outline.read(token);
    }
    while (!outline.open.isEmpty()) {
      outline.close(text.length());
    }
    return outline.all;
  }

  private void read(Matcher token) {
    if (token.group().equals("{")) {
      open.push(new Part(token.start()));
    } else if (token.group().equals("}")) {
      if (!open.isEmpty()) {
        close(token.end());
      }
    } else if (token.group(2) != null && NAMES.containsKey(token.group(1)) && !open.isEmpty()) {
      Part part = open.peek();
      if (part.name.isEmpty()) {
        part.name = token.group(2);
        part.nameStart = token.start(2);
        part.kind = NAMES.get(token.group(1));
      }
    }
  }

  /** Ends an object; the parts of one without a name belong to what is around it. */
  private void close(int end) {
    Part part = open.pop();
    List<Symbol> around = open.isEmpty() ? all : open.peek().parts;
    if (part.name.isBlank()) {
      around.addAll(part.parts);
      return;
    }
    around.add(
        new Symbol(
            part.name,
            "",
            part.kind,
            lines.range(part.start, end),
            lines.range(part.nameStart, part.nameStart + part.name.length()),
            part.parts));
  }
}
