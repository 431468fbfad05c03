package dev.eventchain.pipeline.diagram;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

/** Contents of pictures and their sources. */
final class Pictures {

  /** Elements that the library creates for text without markup. */
  private static final Set<String> ELEMENTS =
      Set.of(
          "svg", "defs", "g", "title", "rect", "text", "path", "polygon", "ellipse", "line",
          "circle");

  private Pictures() {}

  /** Returns the first words of the lines, which must not contain names. */
  static List<String> lines(String text) {
    return text.lines().map(line -> line.replaceAll("\".*\"|= .*|=\u00a0.*|^  .*", "")).toList();
  }

  /** Returns the names of the elements; fails for one that text does not need. */
  static Set<String> shape(String svg) throws Exception {
    NodeList all = parsed(svg).getElementsByTagName("*");
    Set<String> names = new TreeSet<>();
    for (int index = 0; index < all.getLength(); index++) {
      Element element = (Element) all.item(index);
      names.add(element.getTagName());
      assertFalse(element.hasAttribute("href") || element.hasAttribute("xlink:href"));
      assertFalse(element.hasAttribute("onclick") || element.hasAttribute("font-style"));
    }
    assertTrue(ELEMENTS.containsAll(names), names::toString);
    return names;
  }

  /** Returns the texts of the picture, with ordinary spaces. */
  static List<String> texts(String svg) {
    return contents(svg, "text");
  }

  /** Returns what the picture says about its parts, with ordinary spaces. */
  static List<String> titles(String svg) {
    return contents(svg, "title");
  }

  private static List<String> contents(String svg, String element) {
    try {
      NodeList all = parsed(svg).getElementsByTagName(element);
      List<String> texts = new ArrayList<>();
      for (int index = 0; index < all.getLength(); index++) {
        texts.add(all.item(index).getTextContent().replace('\u00a0', ' '));
      }
      return texts;
    } catch (Exception e) {
      throw new AssertionError(svg, e);
    }
  }

  private static Document parsed(String svg) throws Exception {
    DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
    factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
    return factory.newDocumentBuilder().parse(new InputSource(new StringReader(svg)));
  }

  /** Returns the matches of a regular expression in a text. */
  static List<MatchResult> matches(String pattern, String text) {
    return Pattern.compile(pattern).matcher(text).results().toList();
  }
}
