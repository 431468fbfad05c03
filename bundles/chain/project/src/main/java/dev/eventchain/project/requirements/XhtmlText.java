package dev.eventchain.project.requirements;

import dev.eventchain.documents.XmlElement;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * Plain text of XHTML: blocks are apart from each other, entries of lists begin with a dash or a
 * number, cells of tables are divided by bars and rows by semicolons.
 */
final class XhtmlText {

  private static final Set<String> BLOCKS =
      Set.of(
          "address",
          "blockquote",
          "br",
          "dd",
          "div",
          "dl",
          "dt",
          "h1",
          "h2",
          "h3",
          "h4",
          "h5",
          "h6",
          "hr",
          "ol",
          "p",
          "pre",
          "table",
          "ul");

  private final StringBuilder text = new StringBuilder();
  private boolean reduced;

  /** Returns the text of an element. */
  static XhtmlText of(XmlElement element) {
    XhtmlText text = new XhtmlText();
    text.add(element);
    return text;
  }

  /** Returns the text on one line. */
  String text() {
    return text.toString().strip().replaceAll("\\s+", " ");
  }

  /** Returns whether it has objects, such as pictures, of which only a description is text. */
  boolean isReduced() {
    return reduced;
  }

  /** Returns the name of an element without a prefix. */
  static String name(XmlElement element) {
    return element.name().substring(element.name().indexOf(':') + 1);
  }

  private void add(XmlElement element) {
    int item = 0;
    boolean ordered = name(element).equals("ol");
    for (int i = 0; i < element.children().size(); i++) {
      XmlElement child = element.children().get(i);
      text.append(element.textBefore(i));
      String name = name(child).toLowerCase(Locale.ROOT);
      text.append(BLOCKS.contains(name) ? " " : "");
      switch (name) {
        case "table" -> text.append(String.join("; ", rows(child)));
        case "li" -> entry(child, ordered ? ++item + "." : "-");
        case "object", "img" -> object(child);
        default -> add(child);
      }
      text.append(BLOCKS.contains(name) ? " " : "");
    }
    text.append(element.textBefore(element.children().size()));
  }

  private void entry(XmlElement entry, String mark) {
    text.append(' ').append(mark).append(' ');
    add(entry);
  }

  private void object(XmlElement object) {
    reduced = true;
    object.attribute("alt").ifPresent(text::append);
    add(object);
  }

  /** Returns the rows of a table or of a part of it. */
  private List<String> rows(XmlElement table) {
    List<String> rows = new ArrayList<>();
    for (XmlElement part : table.children()) {
      if (name(part).equals("tr")) {
        rows.add(String.join(" | ", part.children().stream().map(this::inner).toList()));
      } else if (name(part).equals("caption")) {
        rows.add(inner(part));
      } else {
        rows.addAll(rows(part));
      }
    }
    return rows;
  }

  private String inner(XmlElement cell) {
    XhtmlText inner = of(cell);
    reduced |= inner.reduced;
    return inner.text();
  }
}
