package dev.eventchain.m2t;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.Steps.FileMode;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.UnsupportedCharsetException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;

/** The files that a run makes, with the protected areas of the earlier ones kept in them. */
final class GeneratedFiles {
  /**
   * A file that is being written: the areas that people filled, the ids met so far, and the
   * contents that placeholders stand for.
   */
  private record Open(Map<String, String> areas, Set<String> ids, List<String> kept) {

    /** Made of characters that Unicode reserves for such use and that no text has. */
    static String placeholder(int index) {
      return PLACEHOLDER_START + Integer.toString(index) + PLACEHOLDER_END;
    }

    /** What the placeholder from one offset to another stands for; null if it is none. */
    String content(String text, int start, int end) {
      String number = text.substring(start + 1, Math.max(start + 1, end));
      return number.matches("[0-9]{1,9}") && Integer.parseInt(number) < kept.size()
          ? kept.get(Integer.parseInt(number))
          : null;
    }
  }

  private static final char PLACEHOLDER_START = '\uFDD0';
  private static final char PLACEHOLDER_END = '\uFDD1';

  private final GenerationRun run;
  private final Function<String, Optional<byte[]>> earlier;
  private final SortedMap<String, byte[]> contents = new TreeMap<>();

  /** The names in {@link #contents}, which are faster to ask for here. */
  private final Set<String> names = new HashSet<>();

  private final Deque<Open> open = new ArrayDeque<>();

  GeneratedFiles(GenerationRun run, Function<String, Optional<byte[]>> earlier) {
    this.run = run;
    this.earlier = earlier;
  }

  /** All files so far; to be copied. */
  SortedMap<String, byte[]> contents() {
    return contents;
  }

  /** Makes a file of what something writes. */
  void write(SourceLocation place, String name, FileMode mode, String charsetName, Step body) {
    OutputPath path = OutputPath.of(name);
    Optional<Charset> charset = charset(place, charsetName);
    if (path.refused()) {
      var refused = OutputFolder.refused(name, path);
      run.error(refused.id(), place, refused.message(), refused.hint());
      return;
    }
    boolean again = names.contains(path.value());
    if (again && mode == FileMode.OVERWRITE) {
      run.error(
          "m2t.file.duplicate",
          place,
          "The file '" + path.value() + "' was written before in this run; the first is kept.",
          "Give each file a name of its own, or append: [file (name, true)].");
      return;
    }
    if (charset.isEmpty() || keepExisting(path.value(), mode)) {
      return;
    }
    String text = text(path.value(), charset.get(), body);
    byte[] bytes = bytes(place, path.value(), text, charset.get());
    put(
        path.value(),
        names.contains(path.value()) ? joined(contents.get(path.value()), bytes) : bytes);
  }

  private void put(String path, byte[] content) {
    names.add(path);
    contents.put(path, content);
  }

  private boolean keepExisting(String path, FileMode mode) {
    if (mode != FileMode.CREATE) {
      return false;
    }
    if (names.contains(path)) {
      return true;
    }
    Optional<byte[]> existing = earlier.apply(path);
    existing.ifPresent(content -> put(path, content));
    return existing.isPresent();
  }

  private String text(String path, Charset charset, Step body) {
    Map<String, String> areas =
        earlier
            .apply(path)
            .map(content -> ProtectedAreas.of(new String(content, charset)))
            .orElse(Map.of());
    open.push(new Open(areas, new HashSet<>(), new ArrayList<>()));
    OutputBuffer output = run.output();
    OutputBuffer.Part part = output.beginText();
    String text;
    Optional<OriginMarks> marks;
    Open closed;
    try {
      body.write(run);
      text = output.textOf(part);
      marks = output.marksOf(part);
    } finally {
      output.cut(part);
      closed = open.pop();
    }
    keepLost(path, charset, closed);
    return filled(path, text, closed, marks);
  }

  /** What people wrote, with which neither indentation nor any operation may meddle. */
  private String filled(String path, String text, Open file, Optional<OriginMarks> marks) {
    if (file.kept().isEmpty()) {
      marks.ifPresent(origins -> run.tracing().file(path, text, origins));
      return text;
    }
    OutputBuffer filled = new OutputBuffer(marks.isPresent());
    OutputBuffer.Part all = filled.mark();
    int from = 0;
    int start = text.indexOf(PLACEHOLDER_START);
    while (start >= 0) {
      int end = text.indexOf(PLACEHOLDER_END, start);
      String content = file.content(text, start, end);
      if (content != null) {
        append(text, from, start, marks, filled);
        append(content, 0, content.length(), marks.map(any -> OriginMarks.NOWHERE), filled);
        from = end + 1;
      }
      start = text.indexOf(PLACEHOLDER_START, start + 1);
    }
    append(text, from, text.length(), marks, filled);
    String whole = filled.textOf(all);
    filled.marksOf(all).ifPresent(origins -> run.tracing().file(path, whole, origins));
    return whole;
  }

  private static void append(
      String text, int from, int to, Optional<OriginMarks> marks, OutputBuffer filled) {
    String part = text.substring(from, to);
    if (marks.isEmpty()) {
      filled.append(part);
    } else {
      filled.append(part, marks.get().between(from, to));
    }
  }

  /** Saves the areas that the file has no longer, beside it. */
  private void keepLost(String path, Charset charset, Open closed) {
    String lostPath = path + ".lost";
    String before = earlier.apply(lostPath).map(content -> new String(content, charset)).orElse("");
    StringBuilder lost = new StringBuilder(before);
    closed
        .areas()
        .forEach(
            (id, content) -> {
              if (!closed.ids().contains(id)) {
                lost.append(ProtectedAreas.START).append(id).append(content);
                lost.append(ProtectedAreas.END).append('\n');
                run.warn(
                    "m2t.protected.lost",
                    SourceLocation.of(path),
                    "The protected area '"
                        + id
                        + "' is no longer generated; its content was saved"
                        + " in '"
                        + lostPath
                        + "'.",
                    "Move the content to where it belongs now, and delete the file.");
              }
            });
    if (lost.length() > 0) {
      put(lostPath, lost.toString().getBytes(charset));
    }
  }

  /** Notes an area; false if there can be none of this id here, which has been reported. */
  boolean beginArea(SourceLocation place, String id) {
    String problem = "";
    if (open.isEmpty()) {
      problem = "stands outside of any file";
    } else if (id.isEmpty() || id.indexOf('\n') >= 0 || id.indexOf('\r') >= 0) {
      problem = "has an id that is not one line of text";
    } else if (!open.element().ids().add(id)) {
      problem = "has an id that another area of the file has";
    }
    if (!problem.isEmpty()) {
      run.error(
          "m2t.protected.id",
          place,
          "The protected area '" + OutputPath.shown(id) + "' " + problem + ".",
          "Give each area of a file an id of its own.");
    }
    return problem.isEmpty();
  }

  /**
   * A placeholder for what people wrote into an area of the file that is being written; nothing if
   * there is no such area yet.
   */
  Optional<String> keptArea(String id) {
    Open file = open.element();
    String content = file.areas().get(id);
    if (content == null) {
      return Optional.empty();
    }
    file.kept().add(content);
    return Optional.of(Open.placeholder(file.kept().size() - 1));
  }

  private Optional<Charset> charset(SourceLocation place, String name) {
    if (name.isEmpty()) {
      return Optional.of(StandardCharsets.UTF_8);
    }
    try {
      return Optional.of(Charset.forName(name));
    } catch (IllegalCharsetNameException | UnsupportedCharsetException e) {
      run.error("m2t.charset", place, "There is no charset '" + name + "'.", "Write 'UTF-8'.");
      return Optional.empty();
    }
  }

  private byte[] bytes(SourceLocation place, String path, String text, Charset charset) {
    if (charset.equals(StandardCharsets.UTF_8)) {
      byte[] bytes = text.getBytes(charset);
      if (bytes.length == text.length()) {
        return bytes; // nothing but ASCII, of which nothing can have been lost
      }
    }
    try {
      ByteBuffer encoded = charset.newEncoder().encode(CharBuffer.wrap(text));
      byte[] bytes = new byte[encoded.remaining()];
      encoded.get(bytes);
      return bytes;
    } catch (CharacterCodingException e) {
      run.error(
          "m2t.charset",
          place,
          "The text of '" + path + "' has characters that " + charset + " lacks; they became '?'.",
          "Write the file in UTF-8.");
      return text.getBytes(charset);
    }
  }

  private static byte[] joined(byte[] first, byte[] second) {
    ByteArrayOutputStream joined = new ByteArrayOutputStream(first.length + second.length);
    joined.writeBytes(first);
    joined.writeBytes(second);
    return joined.toByteArray();
  }
}
