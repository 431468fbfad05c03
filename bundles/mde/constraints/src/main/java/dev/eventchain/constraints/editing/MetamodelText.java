package dev.eventchain.constraints.editing;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.XmlEvents;
import dev.eventchain.editing.TextLines;
import dev.eventchain.ocl.metamodel.OclAnnotations;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * One version of an {@code .ecore} file: its named elements, and the expressions in its
 * annotations.
 *
 * @param source the text with the characters of expressions in place of their escapes, and spaces
 *     behind them, so that offsets are the same
 */
record MetamodelText(
    Path file,
    SourceText written,
    SourceText source,
    TextLines lines,
    List<Named> elements,
    List<Embedded> expressions) {

  private static final int DEEPEST = 100;

  private static final Pattern ESCAPE =
      Pattern.compile("&(lt|gt|amp|quot|apos|#(\\d{1,7})|#x([0-9A-Fa-f]{1,6}));");

  /** Characters of operators, which stay together if some of them are escaped. */
  private static final Pattern RUN = Pattern.compile("(?:" + ESCAPE + "|[-=<>])+");

  /**
   * A package, a class, a feature or an operation.
   *
   * @param path its name after those of the elements around it
   * @param start the offset of its name
   */
  record Named(List<String> path, String tag, int tagStart, int start) {

    String name() {
      return path.get(path.size() - 1);
    }

    int end() {
      return start + name().length();
    }
  }

  /**
   * An expression.
   *
   * @param owner the path of the element that has the annotation
   */
  record Embedded(List<String> owner, String key, int start, int end) {}

  static MetamodelText of(Path file, SourceText written) {
    Reader reader = new Reader(written);
    try {
      XmlEvents.read(written, DEEPEST, reader);
    } catch (XmlEvents.MalformedException e) {
      // What stands before the fault is known; the fault is reported elsewhere.
    }
    StringBuilder plain = new StringBuilder(written.text());
    reader.expressions.forEach(each -> unescape(plain, each.start(), each.end()));
    return new MetamodelText(
        file,
        written,
        SourceText.of(written.name(), plain.toString()),
        new TextLines(written.text()),
        reader.elements,
        reader.expressions);
  }

  private static void unescape(StringBuilder text, int start, int end) {
    Matcher run = RUN.matcher(text.toString()).region(start, end);
    while (run.find()) {
      StringBuilder plain = new StringBuilder();
      Matcher escape = ESCAPE.matcher(run.group());
      while (escape.find()) {
        escape.appendReplacement(plain, Matcher.quoteReplacement(character(escape)));
      }
      escape.appendTail(plain);
      int blank = run.end() - run.start() - plain.length();
      text.replace(run.start(), run.end(), plain + " ".repeat(blank));
    }
  }

  private static String character(Matcher escape) {
    return switch (escape.group(1)) {
      case "lt" -> "<";
      case "gt" -> ">";
      case "amp" -> "&";
      case "quot" -> "\"";
      case "apos" -> "'";
      default -> {
        boolean decimal = escape.group(2) != null;
        int code = Integer.parseInt(escape.group(decimal ? 2 : 3), decimal ? 10 : 16);
        yield code > 0 && code < Character.MAX_VALUE ? String.valueOf((char) code) : " ";
      }
    };
  }

  /** Reads an {@code .ecore} file from tag to tag. */
  private static final class Reader implements XmlEvents.Handler {
    private final SourceText written;
    private final List<Named> elements = new ArrayList<>();
    private final List<Embedded> expressions = new ArrayList<>();
    private final Deque<List<String>> around = new ArrayDeque<>();
    private boolean ocl;

    private Reader(SourceText written) {
      this.written = written;
      around.push(List.of());
    }

    @Override
    public void start(String tag, String[] attributes, int offset) {
      List<String> path = around.peek();
      String name = value("name", attributes);
      if (tag.equals("eAnnotations")) {
        ocl = OclAnnotations.isSource(value("source", attributes));
      } else if (tag.equals("details") && ocl) {
        int start = valueStart(offset, "value");
        if (start > 0) {
          int end = end(start);
          expressions.add(new Embedded(path, value("key", attributes), start, end));
        }
      } else if (!name.isEmpty()) {
        List<String> inner = new ArrayList<>(path);
        inner.add(name);
        path = List.copyOf(inner);
        elements.add(new Named(path, tag, offset, valueStart(offset, "name")));
      }
      around.push(path);
    }

    private static String value(String name, String[] attributes) {
      for (int i = 0; i < attributes.length; i += 2) {
        if (attributes[i].equals(name)) {
          return attributes[i + 1];
        }
      }
      return "";
    }

    /** Returns the offset of an attribute's value; 0 if there is no such attribute. */
    private int valueStart(int tag, String attribute) {
      int name = XmlEvents.attribute(written, tag, attribute);
      if (name == tag) {
        return 0;
      }
      int quote = name + attribute.length();
      while (quote < written.text().length() && "\"'".indexOf(written.text().charAt(quote)) < 0) {
        quote++;
      }
      return quote + 1;
    }

    private int end(int start) {
      int end = written.text().indexOf(written.text().charAt(start - 1), start);
      return end < 0 ? written.text().length() : end;
    }

    @Override
    public void text(char[] characters, int from, int length) {}

    @Override
    public void end() {
      around.pop();
    }
  }
}
