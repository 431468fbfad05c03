package dev.eventchain.diagnostics;

import java.io.IOException;
import java.io.InputStream;
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
import java.util.Optional;

/** A named text that converts offsets into locations. Immutable. */
public final class SourceText {

  private static final long LARGEST = 256L << 20;

  private static final int PIECE = 1 << 16;

  private static final char BYTE_ORDER_MARK = '\uFEFF';

  /** Replacement of invalid UTF-8 by Java; a valid text may also contain it. */
  private static final char REPLACEMENT = '\uFFFD';

  private final String name;
  private final String text;
  private final int[] lineStarts;

  /** Most recently requested line, so that many findings on a line of megabytes share one copy. */
  private volatile Line last;

  private record Line(int index, String text) {}

  /** Location of the whole text; null if its lines are those of its file. */
  private final SourceLocation place;

  private SourceText(String name, String text, SourceLocation place) {
    this.name = name;
    this.text = text;
    this.lineStarts = lineStarts(text);
    this.place = place;
  }

  /** Returns a text from memory under its displayed name. */
  public static SourceText of(String name, String text) {
    boolean marked = !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK;
    return new SourceText(name, marked ? text.substring(1) : text, null);
  }

  /**
   * Returns a text that is written with escapes inside another one, such as an XML attribute value.
   * Its offsets are not those of the file, so all of it has one location.
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
   * @throws Cancellation.CancelledException if the result of the work is not wanted any more
   */
  public static SourceText read(Path file) {
    Cancellation.check();
    String name = SourceLocation.nameOf(file);
    Optional<String> unsaved = UnsavedTexts.of(file);
    if (unsaved.isPresent()) {
      FileReads.note(file);
      return withoutNul(of(name, unsaved.get()));
    }
    byte[] bytes = bytesOf(file);
    try {
      return withoutNul(of(name, decode(bytes)));
    } catch (CharacterCodingException e) {
      throw wrongEncoding("The file is not UTF-8 text.", encodingError(name, bytes));
    }
  }

  private static SourceText withoutNul(SourceText text) {
    int nul = text.text.indexOf('\0');
    if (nul >= 0) {
      // The NUL bytes of UTF-16 are valid UTF-8.
      throw wrongEncoding(
          "The file contains a NUL character, which text never does.", text.at(nul));
    }
    return text;
  }

  private static DiagnosticException wrongEncoding(String message, SourceLocation place) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(FileRules.ENCODING, message, place).withHint("Save it as UTF-8."));
  }

  /**
   * Decodes bytes; for large files without an intermediate copy of two bytes for each character.
   */
  private static String decode(byte[] bytes) throws CharacterCodingException {
    String text = new String(bytes, StandardCharsets.UTF_8);
    return text.indexOf(REPLACEMENT) < 0
        ? text
        : StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
  }

  private static byte[] bytesOf(Path file) {
    FileReads.note(file);
    try {
      if (Files.exists(file) && !Files.isDirectory(file)) {
        requireReadable(file);
      }
      return read(file, Math.toIntExact(Math.min(LARGEST, Files.size(file))));
    } catch (NoSuchFileException e) {
      throw refused(FileRules.MISSING, "There is no such file.", file);
    } catch (IOException e) {
      throw Files.isDirectory(file)
          ? refused(FileRules.UNREADABLE, "This is a folder, not a file.", file)
          : FileRules.refusal("The file", file, e);
    }
  }

  /**
   * Reads all bytes in pieces. {@link Files#readAllBytes} would keep a buffer of the file's size
   * outside the heap for as long as the thread lives.
   */
  private static byte[] read(Path file, int size) throws IOException {
    byte[] bytes = new byte[size];
    try (InputStream input = Files.newInputStream(file)) {
      int count = 0;
      int read = 0;
      while (read >= 0 && count < size) {
        read = input.read(bytes, count, Math.min(PIECE, size - count));
        count += Math.max(0, read);
      }
      byte[] rest = input.readAllBytes(); // of a file that has grown meanwhile
      byte[] all = count + rest.length == size ? bytes : Arrays.copyOf(bytes, count + rest.length);
      System.arraycopy(rest, 0, all, count, rest.length);
      return all;
    }
  }

  /** Refuses devices and pipes, which never end, and files beyond the size limit. */
  private static void requireReadable(Path file) throws IOException {
    if (!Files.isRegularFile(file)) {
      throw refused(FileRules.UNREADABLE, "This is not a regular file.", file);
    }
    if (Files.size(file) > LARGEST) {
      throw refused(
          FileRules.UNREADABLE,
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

  /** Returns the reason why a file could not be read or written, without a full stop. */
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
    // Without a reason of the system, Java's message is the file name.
    String reason = e instanceof FileSystemException file ? file.getReason() : e.getMessage();
    return reason == null || reason.isBlank() ? "the system does not say why" : plain(reason);
  }

  /** Returns a plain wording for a known error message of Linux; other messages unchanged. */
  private static String plain(String reason) {
    for (Map.Entry<String, String> known : SAID_BY_THE_SYSTEM.entrySet()) {
      if (reason.contains(known.getKey())) {
        return known.getValue();
      }
    }
    return reason;
  }

  private static DiagnosticException refused(Rule rule, String message, Path file) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT, Diagnostic.of(rule, message, SourceLocation.of(file)));
  }

  /** Returns the line of the first byte that is not UTF-8. */
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

  /** Returns the displayed name of the text. */
  public String name() {
    return name;
  }

  /** Returns the text, without a byte order mark. */
  public String text() {
    return text;
  }

  /** Returns the range of the whole text. */
  public SourceRange whole() {
    return range(0, text.length());
  }

  /**
   * Returns a range of the text.
   *
   * @param start the offset of the first character
   * @param end the offset after the last character
   * @throws IndexOutOfBoundsException if that is not inside the text
   */
  public SourceRange range(int start, int end) {
    return new SourceRange(this, start, end);
  }

  /**
   * Returns the location of an offset.
   *
   * @param offset from 0 to the length of the text; other values are clamped
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
   * Returns the location of a line and a column, both from 1; a line beyond the end counts as the
   * last one.
   */
  public SourceLocation at(int line, int column) {
    if (place != null) {
      return place;
    }
    int index = Math.max(0, Math.min(line - 1, lineStarts.length - 1));
    return new SourceLocation(name, index + 1, Math.max(1, column), "", lineText(index));
  }

  /**
   * Returns the offset of a line and a column, both from 1; never beyond the end of the text.
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

  /**
   * Returns the offset of the last character of the next line end (LF, CRLF or CR); -1 if there is
   * none.
   */
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
