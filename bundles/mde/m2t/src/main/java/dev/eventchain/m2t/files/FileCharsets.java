package dev.eventchain.m2t.files;

import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.report.RunReport;
import dev.eventchain.m2t.syntax.SyntaxRules;
import dev.eventchain.output.ProtectedAreas;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.UnsupportedCharsetException;
import java.util.Arrays;
import java.util.Optional;

/** Conversion between texts and bytes of files, with findings about charsets. */
final class FileCharsets {
  static final Rule ID = SyntaxRules.CHARSET;

  private FileCharsets() {}

  /** Returns the charset of a name; empty, with a warning, if no file can be written in it. */
  static Optional<Charset> named(String name, SourceLocation place, RunReport report) {
    String problem;
    try {
      Charset charset = Charset.forName(name);
      if (charset.canEncode()) {
        return Optional.of(charset);
      }
      problem = "The charset '" + charset + "' can be read but not written.";
    } catch (IllegalCharsetNameException | UnsupportedCharsetException e) {
      problem = "There is no charset '" + name + "'.";
    }
    report.warn(ID, place, problem + " UTF-8 is used instead.", "Write 'UTF-8'.");
    return Optional.empty();
  }

  /** Returns whether the marks of protected areas have the same bytes as in ASCII. */
  static boolean agreesWithAscii(Charset charset) {
    String marks = ProtectedAreas.START + ProtectedAreas.END + "\r\n";
    return Arrays.equals(marks.getBytes(charset), marks.getBytes(StandardCharsets.US_ASCII));
  }

  /** Returns the text of bytes; empty if they are malformed. */
  static Optional<String> decoded(byte[] bytes, Charset charset) {
    String text = new String(bytes, charset);
    if (text.indexOf('\uFFFD') < 0) {
      return Optional.of(text);
    }
    try {
      return Optional.of(charset.newDecoder().decode(ByteBuffer.wrap(bytes)).toString());
    } catch (CharacterCodingException e) {
      return Optional.empty();
    }
  }

  /** Returns the bytes of a text that starts a file or, without a byte order mark, continues it. */
  static byte[] bytes(
      String text, boolean starts, GeneratedFile file, SourceLocation place, RunReport report) {
    Charset charset = file.charset();
    if (charset.equals(StandardCharsets.UTF_8)) {
      byte[] bytes = text.getBytes(charset);
      // An unpaired surrogate becomes one byte, too, so equal lengths do not suffice.
      if (bytes.length == text.length()
          && new String(bytes, StandardCharsets.ISO_8859_1).equals(text)) {
        return bytes;
      }
    }
    byte[] bytes;
    try {
      ByteBuffer encoded = charset.newEncoder().encode(CharBuffer.wrap(text));
      bytes = new byte[encoded.remaining()];
      encoded.get(bytes);
    } catch (CharacterCodingException e) {
      reportLacking(file, place, report);
      bytes = text.getBytes(charset);
    }
    return starts ? bytes : withoutByteOrderMark(bytes, charset);
  }

  private static void reportLacking(GeneratedFile file, SourceLocation place, RunReport report) {
    Charset charset = file.charset();
    report.find(
        ID,
        place,
        "The text of '"
            + file.path()
            + "' has characters that "
            + charset
            + " lacks; they would become '?'.",
        charset.equals(StandardCharsets.UTF_8)
            ? "Use whole characters: this is half of one that Java counts as two."
            : "Write the file in UTF-8.");
  }

  /** Returns the bytes of a text that follows other text. */
  static byte[] continued(String text, Charset charset) {
    return withoutByteOrderMark(text.getBytes(charset), charset);
  }

  private static byte[] withoutByteOrderMark(byte[] bytes, Charset charset) {
    int one = "a".getBytes(charset).length;
    int another = "aa".getBytes(charset).length - one;
    return Arrays.copyOfRange(bytes, Math.min(one - another, bytes.length), bytes.length);
  }
}
