package dev.eventchain.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import java.util.List;
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

  @Test
  void anElementKnowsWhereItsTagsAre() {
    String text =
        "<?a </p> ?><p a='>\"/' b = \"'>\" ><!-- </p> <q> --><q/><q a='/'></q><![CDATA[</p>]]><?b </p>?></p >\n";
    XmlElement root = parse(text);
    assertEquals(
        "<!-- </p> <q> --><q/><q a='/'></q><![CDATA[</p>]]><?b </p>?>",
        text.substring(root.contentStart(), root.contentEnd()));
    assertEquals(
        text.strip().substring(text.indexOf("<p")), text.substring(root.start(), root.end()));
    XmlElement one = root.children().get(0);
    assertEquals("<q/>", text.substring(one.start(), one.end()));
    assertEquals(one.end(), one.contentEnd());
    XmlElement two = root.children().get(1);
    assertEquals("<q a='/'></q>", text.substring(two.start(), two.end()));
    assertEquals(two.contentStart(), two.contentEnd());
    assertEquals(List.of(true, false), List.of(one.isOneTag(), two.isOneTag()));
  }

  private static XmlElement parse(String text) {
    return XmlElement.parse(SourceText.of("a.xml", text), Rule.error("test.syntax"));
  }
}
