package dev.eventchain.roads.xml;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.StringReader;
import java.util.function.Consumer;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * Reader of an OpenDRIVE document that holds one child of the root at a time. Document types, and
 * so all entities but XML's own, are refused.
 */
public final class XmlStream {

  private static final int DEEPEST = 32;

  private final SourceText source;
  private final Problems problems;
  private final Consumer<XmlElement> each;
  private final TagPositions positions;
  private XmlElement current;
  private int depth;

  private XmlStream(SourceText source, Problems problems, Consumer<XmlElement> each) {
    this.source = source;
    this.problems = problems;
    this.each = each;
    this.positions = new TagPositions(source.text());
  }

  /**
   * Reads a document.
   *
   * @param each receives the children of the root, complete, one after the other
   * @throws DiagnosticException for what is no OpenDRIVE document, with all problems so far
   */
  public static void read(SourceText source, Problems problems, Consumer<XmlElement> each) {
    XmlStream stream = new XmlStream(source, problems, each);
    try {
      XMLStreamReader reader = factory().createXMLStreamReader(new StringReader(source.text()));
      while (reader.hasNext()) {
        stream.handle(reader.next(), reader);
      }
    } catch (XMLStreamException e) {
      throw stream.broken(source.at(stream.offsetOf(e)), "The XML is broken: " + reason(e) + ".");
    }
  }

  private static XMLInputFactory factory() {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    factory.setXMLResolver(
        (publicId, systemId, base, namespace) -> {
          throw new XMLStreamException("external entities are not read");
        });
    return factory;
  }

  private int offsetOf(XMLStreamException e) {
    int offset = e.getLocation() == null ? 0 : e.getLocation().getCharacterOffset();
    return Math.max(positions.last(), Math.min(offset, source.text().length()));
  }

  /** Returns the reason in the words of Java's parser, which are on the second line. */
  private static String reason(XMLStreamException e) {
    String message = String.valueOf(e.getMessage());
    int at = message.indexOf("Message: ");
    String reason = at < 0 ? message : message.substring(at + "Message: ".length());
    return reason.strip().replaceFirst("\\.$", "");
  }

  private void handle(int event, XMLStreamReader reader) {
    if (event == XMLStreamConstants.START_ELEMENT) {
      start(reader);
    } else if (event == XMLStreamConstants.END_ELEMENT) {
      end();
    } else if (event == XMLStreamConstants.DTD) {
      int at = Math.max(0, source.text().indexOf("<!DOCTYPE"));
      throw broken(source.at(at), "The file has a document type, which may define entities.");
    } else if (event == XMLStreamConstants.ENTITY_REFERENCE) {
      throw broken(source.at(positions.last()), "The file refers to an entity.");
    } else if (isText(event) && current != null && !reader.isWhiteSpace()) {
      current.append(reader.getText());
    }
  }

  private static boolean isText(int event) {
    return event == XMLStreamConstants.CHARACTERS || event == XMLStreamConstants.CDATA;
  }

  private void start(XMLStreamReader reader) {
    int offset = positions.next();
    depth++;
    if (depth == 1) {
      requireRoot(reader.getLocalName(), offset);
      return;
    }
    if (depth > DEEPEST) {
      throw broken(source.at(offset), "Elements are nested more than " + DEEPEST + " deep.");
    }
    String[] attributes = new String[2 * reader.getAttributeCount()];
    for (int i = 0; i < attributes.length; i += 2) {
      attributes[i] = reader.getAttributeLocalName(i / 2);
      attributes[i + 1] = reader.getAttributeValue(i / 2);
    }
    String name = reader.getLocalName();
    current = new XmlElement(source, problems, name, offset, current, attributes);
  }

  private void requireRoot(String name, int offset) {
    if (!name.equals("OpenDRIVE")) {
      throw broken(
          source.at(offset), "The root is `" + name + "`; that of a road network is `OpenDRIVE`.");
    }
  }

  private void end() {
    depth--;
    if (current != null) {
      XmlElement ended = current;
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
