package dev.eventchain.eclipse.content;

import java.io.IOException;
import java.io.InputStream;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.eclipse.core.runtime.QualifiedName;
import org.eclipse.core.runtime.content.IContentDescription;
import org.eclipse.core.runtime.content.ITextContentDescriber;

/**
 * Distinguishes event chains from other XMI by the namespace of the root element. Reads only the
 * beginning of the file, as text, and follows no references; the rest may be malformed.
 */
public final class ChainDescriber implements ITextContentDescriber {

  private static final int MOST = 64 * 1024;

  @Override
  public int describe(InputStream contents, IContentDescription description) throws IOException {
    byte[] head = contents.readNBytes(MOST);
    byte[] mark = markOf(head);
    if (description != null && mark.length > 0) {
      description.setProperty(IContentDescription.BYTE_ORDER_MARK, mark);
    }
    return validity(decode(head, mark));
  }

  @Override
  public int describe(Reader contents, IContentDescription description) throws IOException {
    char[] head = new char[MOST];
    int length = 0;
    int read = contents.read(head, 0, MOST);
    while (read > 0) {
      length += read;
      read = contents.read(head, length, MOST - length);
    }
    return validity(new String(head, 0, length));
  }

  private static int validity(String head) {
    return new XmlHead(head).isEventChain() ? VALID : INVALID;
  }

  /**
   * Returns whether a file contains an event chain of any version, whose namespace may be unknown.
   */
  public static boolean isOfAnyVersion(Path file) {
    try (InputStream contents = Files.newInputStream(file)) {
      byte[] head = contents.readNBytes(MOST);
      return new XmlHead(decode(head, markOf(head))).isOfAnyVersion();
    } catch (IOException e) {
      return false; // reading the model says why
    }
  }

  private static byte[] markOf(byte[] head) {
    for (byte[] mark :
        new byte[][] {
          IContentDescription.BOM_UTF_8,
          IContentDescription.BOM_UTF_16BE,
          IContentDescription.BOM_UTF_16LE
        }) {
      if (startsWith(head, mark)) {
        return mark;
      }
    }
    return new byte[0];
  }

  private static boolean startsWith(byte[] head, byte[] mark) {
    for (int i = 0; i < mark.length; i++) {
      if (i >= head.length || head[i] != mark[i]) {
        return false;
      }
    }
    return true;
  }

  /**
   * Decodes UTF-16 by its mark, else Latin 1: the relevant names are ASCII, in UTF-8 files, too.
   */
  private static String decode(byte[] head, byte[] mark) {
    return mark.length == 2
        ? new String(head, StandardCharsets.UTF_16)
        : new String(head, mark.length, head.length - mark.length, StandardCharsets.ISO_8859_1);
  }

  @Override
  public QualifiedName[] getSupportedOptions() {
    return new QualifiedName[] {IContentDescription.BYTE_ORDER_MARK};
  }
}
