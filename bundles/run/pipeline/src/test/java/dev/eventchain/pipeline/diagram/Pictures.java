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

/** What pictures and their sources hold. */
final class Pictures {

  /** All that the library makes of text without markup. */
  private static final Set<String> ELEMENTS =
      Set.of("svg", "defs", "g", "rect", "text", "path", "polygon", "ellipse", "line", "circle");

  private Pictures() {}

  /** The first words of the lines, in which no name may come. */
  static List<String> lines(String text) {
    return text.lines().map(line -> line.replaceAll("\".*\"|= .*|=\u00a0.*|^  .*", "")).toList();
  }

  /** The names of the elements; fails for one that text has no need of. */
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

  /** What the picture says, spaces as people type them. */
  static List<String> texts(String svg) {
    try {
      NodeList all = parsed(svg).getElementsByTagName("text");
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

  /** The places in a text that a regular expression matches. */
  static List<MatchResult> matches(String pattern, String text) {
    return Pattern.compile(pattern).matcher(text).results().toList();
  }
}
