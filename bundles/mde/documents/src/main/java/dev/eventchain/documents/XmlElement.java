package dev.eventchain.documents;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.XmlEvents;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * An element of an XML file, with its place. Prefixes of names are kept as they are written.
 * Immutable once it is read.
 */
public final class XmlElement {

  private final SourceText source;
  private final String name;
  private final Map<String, String> attributes;
  private final List<XmlElement> children;
  private final List<String> texts;
  private final int start;

  XmlElement(
      SourceText source,
      String name,
      Map<String, String> attributes,
      List<XmlElement> children,
      List<String> texts,
      int start) {
    this.source = source;
    this.name = name;
    this.attributes = Collections.unmodifiableMap(new LinkedHashMap<>(attributes));
    this.children = Collections.unmodifiableList(children);
    this.texts = Collections.unmodifiableList(texts);
    this.start = start;
  }

  /**
   * Reads a text.
   *
   * @param rule that of a text that is not XML, has a document type, or is nested too deeply
   * @return the root
   * @throws DiagnosticException (INPUT) with that rule and the place
   */
  public static XmlElement parse(SourceText source, Rule rule) {
    return XmlReader.read(source, rule);
  }

  public String name() {
    return name;
  }

  /** Returns the attributes in their order, without declarations of namespaces. */
  public Map<String, String> attributes() {
    return attributes;
  }

  /** Returns the value of an attribute. */
  public Optional<String> attribute(String attribute) {
    return Optional.ofNullable(attributes.get(attribute));
  }

  public List<XmlElement> children() {
    return children;
  }

  /** Returns the children of a name, in their order. */
  public List<XmlElement> children(String child) {
    return children.stream().filter(each -> each.name.equals(child)).toList();
  }

  /** Returns the first child of a name. */
  public Optional<XmlElement> child(String child) {
    for (XmlElement each : children) {
      if (each.name.equals(child)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  /** Returns the text of an element without children, stripped; empty for others. */
  public String text() {
    return children.isEmpty() ? textBefore(0).strip() : "";
  }

  /**
   * Returns the text between two children, as it is written, or empty if it is only white space.
   *
   * @param child the index of the child that follows; the number of children for what follows the
   *     last one
   */
  public String textBefore(int child) {
    return child < texts.size() ? texts.get(child) : "";
  }

  /** Returns the offset of the start tag. */
  public int start() {
    return start;
  }

  /** Returns the offset behind the start tag. */
  public int contentStart() {
    return XmlEvents.tagEnd(source, start);
  }

  /** Returns the offset of the end tag; that behind the start tag, if there is only one tag. */
  public int contentEnd() {
    int content = contentStart();
    if (isOneTag()) {
      return content;
    }
    int last = children.isEmpty() ? content : children.get(children.size() - 1).end();
    return XmlEvents.endTag(source, last);
  }

  /** Returns the offset behind the element. */
  public int end() {
    return isOneTag() ? contentStart() : XmlEvents.tagEnd(source, contentEnd());
  }

  /** Returns whether it is written as one tag, which is start and end. */
  public boolean isOneTag() {
    return source.text().charAt(contentStart() - 2) == '/';
  }

  /** Returns the place of the start tag. */
  public SourceLocation location() {
    return source.at(start);
  }

  /** Returns the place of an attribute's name; that of the start tag if it is not there. */
  public SourceLocation location(String attribute) {
    return attributes.containsKey(attribute)
        ? source.at(XmlEvents.attribute(source, start, attribute))
        : location();
  }

  @Override
  public String toString() {
    return "<" + name + "> at " + location();
  }
}
