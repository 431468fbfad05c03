package dev.eventchain.diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class XmlEventsTest {

  private static List<String> events(String text) throws XmlEvents.MalformedException {
    List<String> events = new ArrayList<>();
    XmlEvents.read(
        SourceText.of("test.xml", text),
        3,
        new XmlEvents.Handler() {
          @Override
          public void start(String name, String[] attributes, int offset) {
            events.add(offset + " " + name + " " + String.join("=", attributes));
          }

          @Override
          public void text(char[] characters, int from, int length) {
            events.add(new String(characters, from, length));
          }

          @Override
          public void end() {
            events.add("end");
          }
        });
    return events;
  }

  /** Tags in comments and texts are none, and a prefix need not be declared. */
  @Test
  void tagsHaveTheirPlaces() throws XmlEvents.MalformedException {
    assertEquals(
        List.of("13 a x=>", "<b/>", "38 x:c y:d=1", "end", "end"),
        events("<!-- <b/> --><a x='>'><![CDATA[<b/>]]><x:c xmlns:y='u' y:d='1'/></a>"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "<a><b></a> | 8 | The element type \"b\" must be terminated by the matching end-tag"
            + " \"</b>\"",
        "<a><b><c><d/></c></b></a> | 9 | elements are nested more than 3 deep",
        "<!DOCTYPE a [<!ENTITY b 'c'>]><a>&b;</a> | 0"
            + " | it has a document type, which may define entities",
        "<a>&b;</a> | 6 | The entity \"b\" was referenced, but not declared",
        "`` | 0 | Premature end of file",
      })
  void refusesWhatIsNoPlainXml(String text, int offset, String reason) {
    XmlEvents.MalformedException refused =
        assertThrows(XmlEvents.MalformedException.class, () -> events(text));
    assertEquals(reason, refused.reason());
    assertEquals(offset, refused.offset());
  }

  @ParameterizedTest
  @CsvSource({"a, 8", "b, 21", "c, 5", "d, 5"})
  void attributesHaveTheirPlaces(String attribute, int offset) {
    SourceText text = SourceText.of("test.xml", "<x/> <y a='b=\"1\" >' \nb = '2'><z c='3'/></y>");
    assertEquals(offset, XmlEvents.attribute(text, 5, attribute));
  }
}
