package dev.eventchain.diagnostics;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;

/**
 * Reading of XML texts from tag to tag. Document types, and so all entities but XML's own, are
 * refused. Prefixes of names are part of them.
 */
public final class XmlEvents {

  private static final String NO_DOCTYPE = "http://apache.org/xml/features/disallow-doctype-decl";

  private static final Pattern TAG = Pattern.compile("<[^\\s/>]+");

  /** White space, the name of an attribute, and its value. */
  private static final Pattern ATTRIBUTE =
      Pattern.compile("\\s+([^\\s=<>/\"']+)\\s*=\\s*(?:\"[^\"]*\"|'[^']*')");

  private XmlEvents() {}

  /** Receiver of tags and texts, in the order in which they stand. */
  public interface Handler {

    /**
     * Takes a start tag.
     *
     * @param attributes names and values in turn, without declarations of namespaces
     * @param offset of the tag
     */
    void start(String name, String[] attributes, int offset);

    /**
     * Takes a part of the text between two tags.
     *
     * @param characters with other ones around, and only until the call returns
     */
    void text(char[] characters, int from, int length);

    /** Takes an end tag, also that of an element without content. */
    void end();
  }

  /** Reason why a text is no XML that is read. */
  public static final class MalformedException extends Exception {

    private static final long serialVersionUID = 1L;

    private final int offset;

    MalformedException(String reason, int offset) {
      super(reason);
      this.offset = offset;
    }

    /** Returns the reason, a sentence without its end. */
    public String reason() {
      return getMessage();
    }

    /** Returns the offset at which it was noticed. */
    public int offset() {
      return offset;
    }
  }

  /**
   * Reads a text to its end.
   *
   * @param deepest the most elements that may be in each other
   * @throws MalformedException at the first thing that is wrong, after all that is before it
   */
  public static void read(SourceText source, int deepest, Handler handler)
      throws MalformedException {
    Adapter adapter = new Adapter(source, deepest, handler);
    try {
      SAXParserFactory factory = SAXParserFactory.newInstance();
      factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
      factory.setFeature(NO_DOCTYPE, true);
      factory.newSAXParser().parse(new InputSource(new StringReader(source.text())), adapter);
    } catch (SAXParseException e) {
      throw adapter.malformed(e);
    } catch (SAXException | ParserConfigurationException e) {
      throw new MalformedException(sentence(e.getMessage()), 0);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String sentence(String message) {
    return String.valueOf(message).strip().replaceFirst("\\.$", "");
  }

  /**
   * Returns the offset of an attribute's name in a tag; that of the tag if it has no such
   * attribute.
   *
   * @param tag the offset of the tag
   */
  public static int attribute(SourceText source, int tag, String attribute) {
    int length = source.text().length();
    Matcher name = TAG.matcher(source.text()).region(tag, length);
    int end = name.lookingAt() ? name.end() : length;
    Matcher each = ATTRIBUTE.matcher(source.text()).region(end, length);
    while (each.lookingAt()) {
      if (each.group(1).equals(attribute)) {
        return each.start(1);
      }
      each.region(each.end(), length);
    }
    return tag;
  }

  /**
   * Returns the offset behind a tag of a well-formed text.
   *
   * @param tag the offset of the tag
   */
  public static int tagEnd(SourceText source, int tag) {
    String text = source.text();
    int end = tag;
    while (text.charAt(end) != '>') {
      char each = text.charAt(end);
      end = each == '"' || each == '\'' ? text.indexOf(each, end + 1) + 1 : end + 1;
    }
    return end + 1;
  }

  /**
   * Returns the offset of the next end tag of a well-formed text.
   *
   * @param from an offset behind a tag, from which on no other element begins before that end tag
   */
  public static int endTag(SourceText source, int from) {
    return TagPositions.endTag(source.text(), from);
  }

  /** Hands on what Java's parser says. */
  private static final class Adapter extends DefaultHandler {

    private final SourceText source;
    private final Handler handler;
    private final TagPositions positions;
    private final int deepest;
    private Locator locator;
    private int tag;
    private int depth;

    Adapter(SourceText source, int deepest, Handler handler) {
      this.source = source;
      this.deepest = deepest;
      this.handler = handler;
      this.positions = new TagPositions(source.text());
    }

    MalformedException malformed(SAXParseException e) {
      if (depth > deepest) {
        return new MalformedException(e.getMessage(), tag);
      }
      int doctype = source.text().indexOf("<!DOCTYPE");
      return doctype >= 0 && e.getMessage().contains("DOCTYPE")
          ? new MalformedException("it has a document type, which may define entities", doctype)
          : new MalformedException(
              sentence(e.getMessage()), source.offset(e.getLineNumber(), e.getColumnNumber()));
    }

    @Override
    public void setDocumentLocator(Locator to) {
      locator = to;
    }

    @Override
    public void startElement(String uri, String local, String name, Attributes attributes)
        throws SAXException {
      tag = positions.next();
      depth++;
      if (depth > deepest) {
        throw new SAXParseException("elements are nested more than " + deepest + " deep", locator);
      }
      handler.start(name, valuesOf(attributes), tag);
    }

    private static String[] valuesOf(Attributes attributes) {
      int count = 0;
      String[] values = new String[2 * attributes.getLength()];
      for (int i = 0; i < attributes.getLength(); i++) {
        String name = attributes.getQName(i);
        if (!name.startsWith("xmlns")) {
          values[count++] = name;
          values[count++] = attributes.getValue(i);
        }
      }
      return count == values.length ? values : Arrays.copyOf(values, count);
    }

    @Override
    public void characters(char[] characters, int from, int length) {
      handler.text(characters, from, length);
    }

    @Override
    public void endElement(String uri, String local, String name) {
      depth--;
      handler.end();
    }

    @Override
    public void error(SAXParseException e) throws SAXException {
      throw e;
    }
  }
}
