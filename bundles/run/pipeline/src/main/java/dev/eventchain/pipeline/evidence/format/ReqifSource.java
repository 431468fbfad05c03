package dev.eventchain.pipeline.evidence.format;

import dev.eventchain.diagnostics.XmlText;
import dev.eventchain.pipeline.evidence.Evidence;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import org.xml.sax.SAXException;
import org.xml.sax.helpers.DefaultHandler;

/**
 * The ReqIF document to which verdicts are added: the one that all requirements come from, or else
 * a new one.
 *
 * @param charset its encoding, which it keeps
 */
record ReqifSource(String text, Charset charset) {

  private static final int LONGEST_DECLARATION = 200;

  /**
   * Returns the document for the requirements of a project.
   *
   * @throws IOException if it cannot be read, or is no ReqIF with all of them
   */
  static ReqifSource of(Evidence evidence) throws IOException {
    List<String> files =
        evidence.requirements().stream().map(each -> each.place().file()).distinct().toList();
    boolean isReqif = files.size() == 1 && files.get(0).endsWith(".reqif");
    return isReqif
        ? read(Path.of(files.get(0)), evidence)
        : new ReqifSource(ReqifDocument.of(evidence), StandardCharsets.UTF_8);
  }

  private static ReqifSource read(Path file, Evidence evidence) throws IOException {
    byte[] bytes = Files.readAllBytes(file);
    requireReqif(bytes, file);
    Charset charset = charset(bytes, file);
    String text = charset.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
    List<String> missing = ReqifVerdicts.missing(text, evidence);
    if (!missing.isEmpty()) {
      throw new IOException(file + " has no object for " + String.join(", ", missing));
    }
    return new ReqifSource(text, charset);
  }

  /** Refuses what is not well-formed, and document type declarations, which ReqIF has not. */
  private static void requireReqif(byte[] bytes, Path file) throws IOException {
    DefaultHandler nothing = new DefaultHandler();
    try {
      SAXParserFactory factory = SAXParserFactory.newInstance();
      factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
      factory.newSAXParser().parse(new ByteArrayInputStream(bytes), nothing);
    } catch (SAXException e) {
      throw new IOException(file + " is no ReqIF document: " + e.getMessage(), e);
    } catch (ParserConfigurationException e) {
      throw new IllegalStateException("Java's own parser knows the feature", e);
    }
  }

  /** Returns the encoding; one that begins with a mark of its byte order keeps both. */
  private static Charset charset(byte[] bytes, Path file) throws IOException {
    byte[] head = Arrays.copyOf(bytes, Math.min(bytes.length, LONGEST_DECLARATION));
    try {
      Charset charset = XmlText.charsetOf(head);
      if (!charset.equals(StandardCharsets.UTF_16)) {
        return charset;
      }
      return head[0] == (byte) 0xFF ? StandardCharsets.UTF_16LE : StandardCharsets.UTF_16BE;
    } catch (IllegalArgumentException e) {
      throw new IOException(file + " has an unknown encoding: " + e.getMessage(), e);
    }
  }

  /** Returns the document with the verdicts. */
  byte[] withVerdicts(Evidence evidence) {
    return ReqifVerdicts.add(text, evidence).getBytes(charset);
  }
}
