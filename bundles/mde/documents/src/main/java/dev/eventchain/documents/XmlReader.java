package dev.eventchain.documents;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.XmlEvents;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Builds the tree of an XML text. */
final class XmlReader implements XmlEvents.Handler {

  /** An element whose end has not come. */
  private record Open(
      String name,
      Map<String, String> attributes,
      List<XmlElement> children,
      List<String> texts,
      StringBuilder text,
      int start) {

    /** Keeps the text since the last child, with an index as large as the number of children. */
    void endText() {
      if (!text.toString().isBlank()) {
        while (texts.size() < children.size()) {
          texts.add("");
        }
        texts.add(text.toString());
      }
      text.setLength(0);
    }
  }

  private final SourceText source;
  private final Deque<Open> open = new ArrayDeque<>();
  private XmlElement root;

  private XmlReader(SourceText source) {
    this.source = source;
  }

  static XmlElement read(SourceText source, Rule rule) {
    XmlReader reader = new XmlReader(source);
    try {
      XmlEvents.read(source, Document.DEEPEST, reader);
      return reader.root;
    } catch (XmlEvents.MalformedException e) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  rule, "This is not readable XML: " + e.reason() + ".", source.at(e.offset()))
              .withHint("Correct the file there; leave out a <!DOCTYPE ...>."));
    }
  }

  @Override
  public void start(String name, String[] attributes, int offset) {
    Map<String, String> values = new LinkedHashMap<>();
    for (int i = 0; i < attributes.length; i += 2) {
      values.put(attributes[i], attributes[i + 1]);
    }
    if (!open.isEmpty()) {
      open.peek().endText();
    }
    open.push(
        new Open(name, values, new ArrayList<>(), new ArrayList<>(), new StringBuilder(), offset));
  }

  @Override
  public void text(char[] characters, int from, int length) {
    open.peek().text().append(characters, from, length);
  }

  @Override
  public void end() {
    Open done = open.pop();
    done.endText();
    XmlElement element =
        new XmlElement(
            source, done.name(), done.attributes(), done.children(), done.texts(), done.start());
    if (open.isEmpty()) {
      root = element;
    } else {
      open.peek().children().add(element);
    }
  }
}
