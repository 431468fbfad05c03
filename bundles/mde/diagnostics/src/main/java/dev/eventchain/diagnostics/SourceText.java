package dev.eventchain.diagnostics;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;

/** A text and its name, which turns offsets into locations. Immutable. */
public final class SourceText {

  private static final long LARGEST = 256L << 20;

  private static final char BYTE_ORDER_MARK = '\uFEFF';

  /** What Java puts in place of bytes that are not UTF-8; a text may also hold it. */
  private static final char REPLACEMENT = '\uFFFD';

  private final String name;
  private final String text;
  private final int[] lineStarts;

  /** The line that was last asked for: many findings on a line of megabytes share one copy. */
  private volatile Line last;

  private record Line(int index, String text) {}

  /** Where all of the text is; null if its own lines are those of its file. */
  private final SourceLocation place;

  private SourceText(String name, String text, SourceLocation place) {
    this.name = name;
    this.text = text;
    this.lineStarts = lineStarts(text);
    this.place = place;
  }

  /** A text that is in memory already, under the name that people know it by. */
  public static SourceText of(String name, String text) {
    boolean marked = !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK;
    return new SourceText(name, marked ? text.substring(1) : text, null);
  }

  /**
   * A text that is written in another one with escapes, as an attribute's value in XML is, so that
   * its offsets are none of the file: all of it is at one place.
   */
  public static SourceText within(SourceLocation place, String text) {
    return new SourceText(place.file(), text, place);
  }

  /**
   * Reads a file as UTF-8; a byte order mark is skipped.
   *
   * @throws DiagnosticException for a missing file ({@code file.missing}), one that cannot be read
   *     ({@code file.unreadable}), or one that is not UTF-8 text ({@code file.encoding}), as none
   *     with a NUL character is
   */
  public static SourceText read(Path file) {
    String name = SourceLocation.nameOf(file);
    byte[] bytes = bytesOf(file);
    try {
      SourceText text = of(name, decode(bytes));
      int nul = text.text.indexOf('\0');
      if (nul >= 0) {
        // What UTF-16 writes between the letters is valid UTF-8.
        throw wrongEncoding(
            "The file contains a NUL character, which text never does.", text.at(nul));
      }
      return text;
    } catch (CharacterCodingException e) {
      throw wrongEncoding("The file is not UTF-8 text.", encodingError(name, bytes));
    }
  }

  private static DiagnosticException wrongEncoding(String message, SourceLocation place) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.error("file.encoding", message, place).withHint("Save it as UTF-8."));
  }

  /** Large files are decoded without a copy of two bytes for each character on the way. */
  private static String decode(byte[] bytes) throws CharacterCodingException {
    String text = new String(bytes, StandardCharsets.UTF_8);
    return text.indexOf(REPLACEMENT) < 0
        ? text
        : StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
  }

  private static byte[] bytesOf(Path file) {
    try {
      if (Files.exists(file) && !Files.isDirectory(file)) {
        requireReadable(file);
      }
      return Files.readAllBytes(file);
    } catch (NoSuchFileException e) {
      throw unreadable("file.missing", "There is no such file.", file);
    } catch (IOException e) {
      String problem = Files.isDirectory(file) ? "this is a folder" : reason(e);
      throw unreadable("file.unreadable", "The file cannot be read: " + problem + ".", file);
    }
  }

  /** A device or a pipe never ends, and no text of a project is as large as the limit. */
  private static void requireReadable(Path file) throws IOException {
    if (!Files.isRegularFile(file)) {
      throw unreadable("file.unreadable", "This is not a regular file.", file);
    }
    if (Files.size(file) > LARGEST) {
      throw unreadable(
          "file.unreadable",
          "The file has " + Files.size(file) + " bytes; at most " + LARGEST + " are read.",
          file);
    }
  }

  private static final Map<String, String> SAID_BY_THE_SYSTEM =
      Map.of(
          "No space left on device", "the disk is full",
          "Disk quota exceeded", "the disk quota is used up",
          "Read-only file system", "the disk is read-only",
          "Permission denied", "permission is denied",
          "Operation not permitted", "permission is denied",
          "No such file or directory", "there is no such file or folder",
          "Is a directory", "this is a folder",
          "Not a directory", "a part of the path is not a folder",
          "File name too long", "the name is too long",
          "Too many open files", "this process has too many files open");

  /** Why a file could not be read or written, in words for people, without a full stop. */
  public static String reason(IOException e) {
    if (e instanceof AccessDeniedException) {
      return "permission is denied";
    } else if (e instanceof NoSuchFileException) {
      return "there is no such file or folder";
    } else if (e instanceof FileAlreadyExistsException) {
      return "a file is in the way";
    } else if (e instanceof NotDirectoryException) {
      return "a part of the path is not a folder";
    } else if (e instanceof FileSystemLoopException) {
      return "the links form a cycle";
    } else if (e instanceof DirectoryNotEmptyException) {
      return "the folder is not empty";
    } else if (e instanceof CharacterCodingException) {
      return "it is not UTF-8 text";
    }
    // Java gives the file's name as the message where the system gives no reason.
    String reason = e instanceof FileSystemException file ? file.getReason() : e.getMessage();
    return reason == null || reason.isBlank() ? "the system does not say why" : plain(reason);
  }

  /** As {@link #reason(IOException)}. */
  public static String reason(UncheckedIOException e) {
    return reason(e.getCause());
  }

  /** What Linux says, as far as it is known, begins such a text or is in brackets. */
  private static String plain(String reason) {
    for (Map.Entry<String, String> known : SAID_BY_THE_SYSTEM.entrySet()) {
      if (reason.contains(known.getKey())) {
        return known.getValue();
      }
    }
    return reason;
  }

  private static DiagnosticException unreadable(String id, String message, Path file) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT, Diagnostic.error(id, message, SourceLocation.of(file)));
  }

  /** The line of the first byte that is not UTF-8. */
  private static SourceLocation encodingError(String name, byte[] bytes) {
    ByteBuffer input = ByteBuffer.wrap(bytes);
    StandardCharsets.UTF_8
        .newDecoder()
        .decode(input, java.nio.CharBuffer.allocate(bytes.length + 1), true);
    int line = 1;
    for (int i = 0; i < input.position(); i++) {
      if (bytes[i] == '\n') {
        line++;
      }
    }
    return new SourceLocation(name, line, 0, "", "");
  }

  /** The name that people know the text by. */
  public String name() {
    return name;
  }

  /** The text, without a byte order mark. */
  public String text() {
    return text;
  }

  /** All of the text. */
  public SourceRange whole() {
    return range(0, text.length());
  }

  /**
   * A part of the text.
   *
   * @param start the offset of the first character
   * @param end the offset after the last character
   * @throws IndexOutOfBoundsException if that is not inside the text
   */
  public SourceRange range(int start, int end) {
    return new SourceRange(this, start, end);
  }

  /**
   * The place of an offset.
   *
   * @param offset from 0 to the length of the text; anything beyond is taken for the nearest end
   */
  public SourceLocation at(int offset) {
    if (place != null) {
      return place;
    }
    int inside = Math.max(0, Math.min(offset, text.length()));
    int found = Arrays.binarySearch(lineStarts, inside);
    int index = found >= 0 ? found : -found - 2;
    return new SourceLocation(name, index + 1, inside - lineStarts[index] + 1, "", lineText(index));
  }

  /**
   * The place of a line and a column, both from 1; a line beyond the end is taken for the last one.
   */
  public SourceLocation at(int line, int column) {
    if (place != null) {
      return place;
    }
    int index = Math.max(0, Math.min(line - 1, lineStarts.length - 1));
    return new SourceLocation(name, index + 1, Math.max(1, column), "", lineText(index));
  }

  /**
   * The offset of a line and a column, both from 1; never beyond the end of the text.
   *
   * @return from 0 to the length of the text
   */
  public int offset(int line, int column) {
    int index = Math.max(0, Math.min(line - 1, lineStarts.length - 1));
    return Math.min(text.length(), lineStarts[index] + Math.max(0, column - 1));
  }

  private String lineText(int index) {
    Line known = last;
    if (known == null || known.index() != index) {
      known = new Line(index, lineAt(index));
      last = known;
    }
    return known.text();
  }

  private String lineAt(int index) {
    int end = index + 1 < lineStarts.length ? lineStarts[index + 1] : text.length();
    int start = lineStarts[index];
    while (end > start && (text.charAt(end - 1) == '\n' || text.charAt(end - 1) == '\r')) {
      end--;
    }
    return text.substring(start, end);
  }

  /** The last character of a line's end, which is LF, CRLF or CR; -1 if there is no more. */
  private static int lineEnd(String text, int from, boolean onlyLineFeeds) {
    if (onlyLineFeeds) {
      return text.indexOf('\n', from);
    }
    for (int i = from; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '\n' || (c == '\r' && !text.startsWith("\n", i + 1))) {
        return i;
      }
    }
    return -1;
  }

  private static int[] lineStarts(String text) {
    int[] starts = new int[16];
    int count = 1;
    boolean onlyLineFeeds = text.indexOf('\r') < 0;
    for (int i = lineEnd(text, 0, onlyLineFeeds); i >= 0; ) {
      if (count == starts.length) {
        starts = Arrays.copyOf(starts, count * 2);
      }
      starts[count++] = i + 1;
      i = lineEnd(text, i + 1, onlyLineFeeds);
    }
    return Arrays.copyOf(starts, count);
  }
}
