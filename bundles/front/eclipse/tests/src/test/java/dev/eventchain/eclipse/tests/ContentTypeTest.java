package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.eclipse.core.runtime.Platform;
import org.eclipse.core.runtime.content.IContentType;
import org.junit.jupiter.api.Test;

/** Tests which files have the content type of event chains. */
class ContentTypeTest {

  private static final String CHAIN = "dev.eventchain.eclipse.chain";
  private static final String ROOT =
      "<eventchain:EventChain xmlns:eventchain=\"http://eventchain.dev/eventchain/1.0\"";
  private static final String XMI =
      "<xmi:XMI xmi:version=\"2.0\" xmlns:xmi=\"http://www.omg.org/XMI\">";

  @Test
  void findsEventChainsByTheirRoot() throws IOException {
    assertEquals(CHAIN, typeOf("a.xmi", ROOT + "/>"));
    assertEquals(CHAIN, typeOf("a.eventchain", "<?xml version=\"1.0\"?>\n" + ROOT + ">"));
    assertEquals(
        CHAIN,
        typeOf(
            "a.xmi", "<EventChain name='a>b'\n xmlns = 'http://eventchain.dev/eventchain/1.0'>"));
    assertEquals(
        CHAIN,
        typeOf("a.xmi", "<e:EventChain xmlns:e=\"http://eventchain.dev/eventchain/1.0\"> <soft"));
  }

  @Test
  void findsEventChainsAmongOtherRoots() throws IOException {
    assertEquals(CHAIN, typeOf("a.xmi", XMI + ROOT + "/></xmi:XMI>"));
    assertEquals(
        CHAIN,
        typeOf("a.xmi", XMI + "<!-- c --><a:B xmlns:a='urn:a'><c/></a:B>" + ROOT + "/></xmi:XMI>"));
    assertNotEquals(
        CHAIN, typeOf("a.xmi", XMI + "<a:B xmlns:a='urn:a'>" + ROOT + "/></a:B></xmi:XMI>"));
    assertNotEquals(CHAIN, typeOf("a.xmi", XMI + "</xmi:XMI>"));
  }

  @Test
  void looksPastWhatMayStandBeforeTheRoot() throws IOException {
    assertEquals(CHAIN, typeOf("a.xmi", "\uFEFF<!-- <a> -->\n" + ROOT + "/>"));
    assertEquals(
        CHAIN,
        typeOf(
            "a.xmi",
            "<!DOCTYPE e SYSTEM \"http://127.0.0.1:1/e.dtd\" [<!ENTITY x \"]><b>\"> <!-- ]> -->]>"
                + ROOT
                + "/>"));
    byte[] utf16 = ("\uFEFF" + ROOT + "/>").getBytes(StandardCharsets.UTF_16LE);
    assertEquals(CHAIN, typeOf("a.xmi", utf16));
  }

  @Test
  void leavesOtherFilesToOthers() throws IOException {
    assertNotEquals(CHAIN, typeOf("a.xmi", ""));
    assertNotEquals(CHAIN, typeOf("a.xmi", "<EventChain/>"));
    assertNotEquals(CHAIN, typeOf("a.xmi", "<a:EventChain xmlns:a='urn:other'/>"));
    assertNotEquals(
        CHAIN, typeOf("a.xmi", "<uml:Model xmlns:uml='urn:uml'>" + ROOT + "/></uml:Model>"));
    assertNotEquals(CHAIN, typeOf("a.xmi", ROOT.replace("<", "&lt;")));
    assertNotEquals(CHAIN, typeOf("a.txt", ROOT + "/>"));
  }

  @Test
  void endsOnAnyBytes() throws IOException {
    Random random = new Random(7);
    byte[] alphabet = "<>!?-[]/=\"' :aEventChain\n&".getBytes(StandardCharsets.US_ASCII);
    for (int i = 0; i < 2000; i++) {
      byte[] bytes = new byte[random.nextInt(60)];
      for (int j = 0; j < bytes.length; j++) {
        bytes[j] = i % 2 == 0 ? (byte) random.nextInt() : alphabet[random.nextInt(alphabet.length)];
      }
      assertNotEquals(CHAIN, typeOf("a.xmi", bytes));
    }
    assertNotEquals(CHAIN, typeOf("a.xmi", "<a ".repeat(500_000)));
    assertNotEquals(CHAIN, typeOf("a.xmi", "<!--" + " ".repeat(5_000_000) + "-->" + ROOT + "/>"));
    assertEquals(CHAIN, typeOf("a.xmi", ROOT + ">" + "<data/>".repeat(500_000)));
  }

  private static String typeOf(String name, String text) throws IOException {
    return typeOf(name, text.getBytes(StandardCharsets.UTF_8));
  }

  private static String typeOf(String name, byte[] bytes) throws IOException {
    IContentType type =
        Platform.getContentTypeManager().findContentTypeFor(new ByteArrayInputStream(bytes), name);
    return type == null ? "" : type.getId();
  }
}
