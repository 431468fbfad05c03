package dev.eventchain.diagnostics;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.UnsupportedCharsetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads XML files in the encoding that they declare: UTF-8 unless they say otherwise. */
public final class XmlText {

  private static final int LONGEST_DECLARATION = 200;

  private static final Pattern DECLARED_ENCODING =
      Pattern.compile("^<\\?xml[^>]*?encoding\\s*=\\s*[\"']([^\"']*)[\"']");

  private XmlText() {}

  /**
   * Reads a file.
   *
   * @param name the name of the file in findings
   * @throws DiagnosticException as {@link SourceText#read} does
   */
  public static SourceText read(Path file, String name) {
    FileReads.note(file);
    if (UnsavedTexts.of(file).isPresent()) {
      return SourceText.of(name, SourceText.read(file).text()); // decoded already
    }
    Charset charset = StandardCharsets.UTF_8;
    try {
      charset = charsetOf(head(file));
    } catch (IOException e) {
      // Reading the whole file reports why it cannot be read.
    } catch (IllegalCharsetNameException | UnsupportedCharsetException e) {
      throw wrongEncoding(
          "The file declares the encoding `"
              + e.getMessage()
              + "`, which is unknown or not its own.",
          name);
    }
    try {
      return charset.equals(StandardCharsets.UTF_8)
          ? SourceText.of(name, SourceText.read(file).text())
          : SourceText.of(name, decode(Files.readAllBytes(file), charset));
    } catch (CharacterCodingException e) {
      throw wrongEncoding("The file is not " + charset + " text, as it declares.", name);
    } catch (IOException e) {
      return SourceText.read(file);
    } catch (DiagnosticException e) {
      throw new DiagnosticException(
          e.reason(), e.diagnostics().stream().map(found -> named(found, name)).toList());
    }
  }

  private static String decode(byte[] bytes, Charset charset) throws CharacterCodingException {
    return charset.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
  }

  private static Diagnostic named(Diagnostic found, String name) {
    SourceLocation place = found.location();
    return found.withLocation(
        new SourceLocation(name, place.line(), place.column(), place.element(), place.excerpt()));
  }

  private static byte[] head(Path file) throws IOException {
    try (var input = Files.newInputStream(file)) {
      return input.readNBytes(LONGEST_DECLARATION);
    }
  }

  /**
   * Returns the encoding that the beginning of a document has or declares.
   *
   * @throws IllegalCharsetNameException if it declares what is no name of an encoding
   * @throws UnsupportedCharsetException if it declares one that is unknown here
   */
  public static Charset charsetOf(byte[] head) {
    if (head.length > 1 && (head[0] & 0xFF) + (head[1] & 0xFF) == 0xFE + 0xFF) {
      return StandardCharsets.UTF_16;
    }
    Matcher declared = DECLARED_ENCODING.matcher(new String(head, StandardCharsets.ISO_8859_1));
    if (!declared.find()) {
      return StandardCharsets.UTF_8;
    }
    Charset charset = Charset.forName(declared.group(1));
    if (charset.name().startsWith("UTF-16") || charset.name().startsWith("UTF-32")) {
      // In the encoding that it names, the declaration would not have been readable here.
      throw new UnsupportedCharsetException(declared.group(1));
    }
    return charset.equals(StandardCharsets.US_ASCII) ? StandardCharsets.UTF_8 : charset;
  }

  private static DiagnosticException wrongEncoding(String message, String name) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(FileRules.ENCODING, message, SourceLocation.of(name))
            .withHint("Save it as UTF-8."));
  }
}
