package dev.eventchain.documents;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;

/** Builds the tree of an XML text. A document type, and so any entity of its own, is refused. */
final class XmlReader extends DefaultHandler {

  private static final String NO_DOCTYPE = "http://apache.org/xml/features/disallow-doctype-decl";

  /** An element whose end has not come. */
  private record Open(
      String name,
      Map<String, String> attributes,
      List<XmlElement> children,
      List<String> texts,
      StringBuilder text,
      int start,
      int end) {

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
  private Locator locator;
  private XmlElement root;

  private XmlReader(SourceText source) {
    this.source = source;
  }

  static XmlElement read(SourceText source, Rule rule) {
    XmlReader reader = new XmlReader(source);
    try {
      SAXParserFactory factory = SAXParserFactory.newInstance();
      factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
      factory.setFeature(NO_DOCTYPE, true);
      factory.newSAXParser().parse(new InputSource(new StringReader(source.text())), reader);
      return reader.root;
    } catch (SAXParseException e) {
      throw refused(rule, e.getMessage(), source.at(e.getLineNumber(), e.getColumnNumber()));
    } catch (SAXException | ParserConfigurationException e) {
      throw refused(rule, e.getMessage(), SourceLocation.of(source.name()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static DiagnosticException refused(Rule rule, String reason, SourceLocation place) {
    String stated = reason.contains("DOCTYPE") ? "A document type is not read." : reason;
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(rule, "This is not readable XML: " + stated, place)
            .withHint("Correct the file there; leave out a <!DOCTYPE ...>."));
  }

  @Override
  public void setDocumentLocator(Locator to) {
    locator = to;
  }

  @Override
  public void startElement(String uri, String local, String name, Attributes attributes)
      throws SAXException {
    if (open.size() >= Document.DEEPEST) {
      throw new SAXParseException(Document.TOO_DEEP, locator);
    }
    Map<String, String> values = new LinkedHashMap<>();
    for (int i = 0; i < attributes.getLength(); i++) {
      if (!attributes.getQName(i).startsWith("xmlns")) {
        values.put(attributes.getQName(i), attributes.getValue(i));
      }
    }
    // The locator is behind the start tag.
    int end = source.offset(locator.getLineNumber(), locator.getColumnNumber());
    int start = Math.max(0, source.text().lastIndexOf("<" + name, end));
    if (!open.isEmpty()) {
      open.peek().endText();
    }
    open.push(
        new Open(
            name, values, new ArrayList<>(), new ArrayList<>(), new StringBuilder(), start, end));
  }

  @Override
  public void characters(char[] characters, int from, int length) {
    open.peek().text().append(characters, from, length);
  }

  @Override
  public void endElement(String uri, String local, String name) {
    Open done = open.pop();
    done.endText();
    XmlElement element =
        new XmlElement(
            source,
            done.name(),
            done.attributes(),
            done.children(),
            done.texts(),
            done.start(),
            done.end());
    if (open.isEmpty()) {
      root = element;
    } else {
      open.peek().children().add(element);
    }
  }

  @Override
  public void error(SAXParseException e) throws SAXException {
    throw e;
  }
}
