package dev.eventchain.model.diagram;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.eventchain.EventChain;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;

class DiagramSvgTest {

  private static Document svg(EventChain chain) throws Exception {
    String text =
        DiagramSvg.of(ChainLayout.of(chain, ChainLayoutTest.SIZES), ChainLayoutTest.SIZES);
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }

  @Test
  void writesEachBoxAndLine() throws Exception {
    Document document = svg(Chains.of("in > a", "a back > out", "a > back"));
    assertEquals(7, document.getElementsByTagName("g").getLength());
    assertEquals("test", document.getElementsByTagName("title").item(0).getTextContent());
    assertTrue(document.getElementsByTagName("path").getLength() >= 2 * 7);
  }

  @Test
  void isWellFormedWhateverNamesSay() throws Exception {
    EventChain chain = Chains.of("in > a");
    chain.setName("<&>\u0001");
    chain.getSoftware().get(0).setName("a\"b<c>&\uFFFE\uD800\u202E");
    assertEquals("<&>\\x01", svg(chain).getElementsByTagName("title").item(0).getTextContent());
  }

  @Test
  void findsLinesUnderAPlace() {
    ChainDiagram diagram =
        ChainLayout.of(Chains.of("> a", "a > b", "a > c"), ChainLayoutTest.SIZES);
    for (ChainDiagram.Line line : diagram.lines()) {
      for (ChainDiagram.Point point : line.points()) {
        assertTrue(Shapes.isNear(line, point.x() + 2, point.y(), 3));
        assertEquals(false, Shapes.isNear(line, point.x() + 200, point.y(), 3));
      }
    }
  }
}
