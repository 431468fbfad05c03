package dev.eventchain.roads.xml;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.XmlEvents;
import java.util.function.Consumer;

/** Reader of an OpenDRIVE document that holds one child of the root at a time. */
public final class XmlStream implements XmlEvents.Handler {

  private static final int DEEPEST = 32;

  private final SourceText source;
  private final Problems problems;
  private final Consumer<CheckedElement> each;
  private CheckedElement current;
  private boolean begun;

  private XmlStream(SourceText source, Problems problems, Consumer<CheckedElement> each) {
    this.source = source;
    this.problems = problems;
    this.each = each;
  }

  /**
   * Reads a document.
   *
   * @param each receives the children of the root, complete, one after the other
   * @throws DiagnosticException for what is no OpenDRIVE document, with all problems so far
   */
  public static void read(SourceText source, Problems problems, Consumer<CheckedElement> each) {
    XmlStream stream = new XmlStream(source, problems, each);
    try {
      XmlEvents.read(source, DEEPEST, stream);
    } catch (XmlEvents.MalformedException e) {
      throw stream.broken(source.at(e.offset()), "The XML is broken: " + e.reason() + ".");
    }
  }

  @Override
  public void start(String name, String[] attributes, int offset) {
    String local = name.substring(name.indexOf(':') + 1);
    if (begun) {
      current = new CheckedElement(source, problems, local, offset, current, attributes);
    } else {
      begun = true;
      requireRoot(local, offset);
    }
  }

  private void requireRoot(String name, int offset) {
    if (!name.equals("OpenDRIVE")) {
      throw broken(
          source.at(offset), "The root is `" + name + "`; that of a road network is `OpenDRIVE`.");
    }
  }

  @Override
  public void text(char[] characters, int from, int length) {
    int at = from;
    while (at < from + length && Character.isWhitespace(characters[at])) {
      at++;
    }
    // The space between elements, which is most of all text.
    if (current != null && at < from + length) {
      current.append(new String(characters, from, length));
    }
  }

  @Override
  public void end() {
    if (current != null) {
      CheckedElement ended = current;
      current = ended.parent();
      if (current == null) {
        each.accept(ended);
      }
    }
  }

  /** Adds a problem after which nothing can be read, and returns all problems. */
  private DiagnosticException broken(SourceLocation place, String message) {
    try {
      problems.add(
          XmlRules.SYNTAX, place, message, "Export the file again; it has to be plain XML.");
      problems.warnings();
    } catch (DiagnosticException e) {
      return e;
    }
    throw new IllegalStateException("an error is no warning");
  }
}
