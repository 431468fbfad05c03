package dev.eventchain.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import org.junit.jupiter.api.Test;

class XmlElementTest {

  @Test
  void textBetweenChildrenIsThatBeforeEach() {
    XmlElement root = parse("<p>It <b>shall</b>\n<i/> brake<br/> now. <!-- x -->Or <u/></p>");
    assertEquals("It ", root.textBefore(0));
    assertEquals("", root.textBefore(1), "only white space");
    assertEquals(" brake", root.textBefore(2));
    assertEquals(" now. Or ", root.textBefore(3));
    assertEquals("", root.textBefore(4));
    assertEquals("", root.text());
    assertEquals("shall", root.children().get(0).text());
    assertEquals("", root.children().get(1).text());
  }

  @Test
  void textOfAnElementWithoutChildrenIsStripped() {
    XmlElement root = parse("<p> a &lt; <![CDATA[b & c]]> </p>");
    assertEquals("a < b & c", root.text());
    assertEquals(" a < b & c ", root.textBefore(0));
  }

  private static XmlElement parse(String text) {
    return XmlElement.parse(SourceText.of("a.xml", text), Rule.error("test.syntax"));
  }
}
