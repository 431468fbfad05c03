package dev.eventchain.catalogue.arxml;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.XmlElement;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * An element of a description.
 *
 * @param path the short names of the elements that it is in, and its own if it has one: {@code
 *     /Signals/Speed}
 */
record ArxmlElement(XmlElement xml, String path) {

  /** Language of texts that are preferred, and that of texts for all languages. */
  private static final List<String> LANGUAGES = List.of("EN", "FOR-ALL");

  /** Returns the element of an XML element that is in one with a path. */
  static ArxmlElement in(String path, XmlElement xml) {
    return new ArxmlElement(xml, shortName(xml).map(name -> path + "/" + name).orElse(path));
  }

  /** Returns the short name of an element of its own; empty if it has none. */
  static Optional<String> shortName(XmlElement xml) {
    return xml.children().stream()
        .filter(it -> local(it).equals("SHORT-NAME"))
        .map(XmlElement::text)
        .filter(name -> !name.isEmpty())
        .findFirst();
  }

  /** Returns the tag of an element without the prefix of its namespace. */
  static String local(XmlElement xml) {
    return xml.name().substring(xml.name().indexOf(':') + 1);
  }

  /** Returns its tag. */
  String tag() {
    return local(xml);
  }

  /** Returns the last part of its path. */
  String name() {
    return path.substring(path.lastIndexOf('/') + 1);
  }

  SourceLocation location() {
    return xml.location();
  }

  /** Returns all elements below it that are reached by tags, one after the other. */
  List<ArxmlElement> all(String... tags) {
    List<ArxmlElement> reached = List.of(this);
    for (String tag : tags) {
      reached =
          reached.stream()
              .flatMap(
                  each ->
                      each.xml.children().stream()
                          .filter(it -> local(it).equals(tag))
                          .map(it -> in(each.path, it)))
              .toList();
    }
    return reached;
  }

  /** Returns whether it is only there in some variants of the vehicle. */
  boolean isVariant() {
    return first("VARIATION-POINT").isPresent();
  }

  /** Returns the first of all elements that are reached by tags. */
  Optional<ArxmlElement> first(String... tags) {
    return all(tags).stream().findFirst();
  }

  /** Returns the text of the first element that is reached by tags; empty for a blank one. */
  Optional<String> text(String... tags) {
    return first(tags).map(ArxmlElement::text).filter(text -> !text.isEmpty());
  }

  /** Returns its text with that of the elements in it, such as raised digits, in one line. */
  String text() {
    StringBuilder text = new StringBuilder();
    add(xml, text);
    return text.toString().replaceAll("\\s+", " ").strip();
  }

  private static void add(XmlElement xml, StringBuilder text) {
    for (int i = 0; i <= xml.children().size(); i++) {
      text.append(xml.textBefore(i));
      if (i < xml.children().size()) {
        XmlElement child = xml.children().get(i);
        text.append(local(child).equals("BR") ? " " : "");
        add(child, text);
      }
    }
  }

  /** Returns its long name and its description, as sentences; empty if it has neither. */
  String about() {
    String name = inOneLanguage("LONG-NAME", "L-4");
    String description = inOneLanguage("DESC", "L-2");
    if (name.isEmpty() || description.isEmpty() || description.startsWith(name)) {
      return name.isEmpty() || !description.isEmpty() ? description : name;
    }
    return (name.matches(".*[.!?]") ? name : name + ".") + " " + description;
  }

  private String inOneLanguage(String what, String each) {
    List<ArxmlElement> texts = all(what, each);
    for (String language : LANGUAGES) {
      for (ArxmlElement text : texts) {
        boolean is = text.attribute("L").toUpperCase(Locale.ROOT).equals(language);
        if (is && !text.text().isEmpty()) {
          return text.text();
        }
      }
    }
    return texts.stream().map(ArxmlElement::text).findFirst().orElse("");
  }

  /** Returns the value of an attribute; empty if it has none. */
  String attribute(String attribute) {
    return xml.attribute(attribute).orElse("").strip();
  }
}
