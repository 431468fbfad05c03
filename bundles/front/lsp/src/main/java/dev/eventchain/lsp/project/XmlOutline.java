package dev.eventchain.lsp.project;

import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextLines;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The elements with names of a model in XMI, in each other; also of a text that is half typed. */
final class XmlOutline {

  private static final int MOST = 10_000;

  private static final Pattern TAG =
      Pattern.compile(
          "<!--.*?-->|<(/?)([A-Za-z_][\\w:.-]*)((?:[^<>\"']++|\"[^\"<]*+\"|'[^'<]*+')*+)>",
          Pattern.DOTALL);

  /** The attribute that names an element; of a requirement, its id. */
  private static final Pattern NAME =
      Pattern.compile("\\s(?:name|id)\\s*=\\s*(?:\"([^\"]*)\"|'([^']*)')");

  /** An element that has not ended. */
  private record Part(int start, Matcher tag, int offset, List<Symbol> parts) {}

  private final TextLines lines;
  private final List<Symbol> all = new ArrayList<>();
  private final Deque<Part> open = new ArrayDeque<>();

  private XmlOutline(TextLines lines) {
    this.lines = lines;
  }

  /** Returns the elements of a text in its order. */
  static List<Symbol> of(String text, TextLines lines) {
    XmlOutline outline = new XmlOutline(lines);
    Matcher tag = TAG.matcher(text);
    for (int i = 0; i < MOST && tag.find(); i++) {
      if (tag.group(2) != null) {
        outline.read(tag);
      }
    }
    while (!outline.open.isEmpty()) {
      outline.close(text.length());
    }
    return outline.all;
  }

  private void read(Matcher tag) {
    boolean ends = !tag.group(1).isEmpty();
    if (!ends) {
      Matcher name = NAME.matcher(tag.group(3));
      open.push(new Part(tag.start(), name, tag.start(3), new ArrayList<>()));
    }
    if (!open.isEmpty() && (ends || tag.group(3).endsWith("/"))) {
      close(tag.end());
    }
  }

  /** Ends an element; the parts of one without a name belong to what is around it. */
  private void close(int end) {
    Part part = open.pop();
    List<Symbol> around = open.isEmpty() ? all : open.peek().parts();
    Matcher name = part.tag();
    int group = name.find() ? (name.group(1) == null ? 2 : 1) : 0;
    if (group == 0 || name.group(group).isBlank()) {
      around.addAll(part.parts());
      return;
    }
    int start = part.offset() + name.start(group);
    around.add(
        new Symbol(
            name.group(group),
            "",
            ElementKind.CLASS,
            lines.range(part.start(), end),
            lines.range(start, start + name.group(group).length()),
            part.parts()));
  }
}
