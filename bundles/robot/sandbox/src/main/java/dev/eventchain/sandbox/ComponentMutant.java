package dev.eventchain.sandbox;

import dev.eventchain.diagnostics.Sha256;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A small defect in one place of a component.
 *
 * @param id its name, which stays the same while the rest of the component changes; unique in the
 *     component
 * @param operator the kind of defect, such as {@code comparison}
 * @param line its place in the component, from 1
 * @param column in characters, from 1
 * @param before what stands there, in normalized layout
 * @param after what the mutant has instead
 * @param edits the changes of the text that make it
 */
public record ComponentMutant(
    String id,
    String operator,
    int line,
    int column,
    String before,
    String after,
    List<Edit> edits) {

  /** Length up to which a part of an id is not shortened. */
  private static final int LONGEST = 80;

  private static final int KEPT = 60;
  private static final int DIGITS = 8;

  /** Copies the list. */
  public ComponentMutant {
    edits = List.copyOf(edits);
  }

  /**
   * A replaced part of a text.
   *
   * @param start in bytes of UTF-8
   * @param end in bytes of UTF-8, exclusive
   */
  record Edit(int start, int end, String text) {}

  /** Returns the name of a mutant; {@code number} counts the mutants that read the same. */
  static String id(String operator, String function, String before, String after, int number) {
    String id = operator + " in " + function + ", " + shortened(before) + " -> " + shortened(after);
    return number == 1 ? id : id + " (" + number + ")";
  }

  private static String shortened(String text) {
    String line = text.replaceAll("\\s+", " ").strip();
    return line.length() <= LONGEST
        ? line
        : line.substring(0, KEPT) + "... " + Sha256.of(line).hex().substring(0, DIGITS);
  }

  /** Returns the lines of the component, from 1, that the defect changes. */
  public IntStream lines(String source) {
    byte[] bytes = source.getBytes(StandardCharsets.UTF_8);
    return edits.stream()
        .flatMapToInt(
            edit -> IntStream.rangeClosed(line(bytes, edit.start()), line(bytes, edit.end())))
        .distinct();
  }

  private static int line(byte[] bytes, int offset) {
    return 1 + (int) IntStream.range(0, offset).filter(at -> bytes[at] == '\n').count();
  }

  /** Returns the text of the component with the defect. */
  public String in(String source) {
    byte[] bytes = source.getBytes(StandardCharsets.UTF_8);
    List<Edit> inOrder = new ArrayList<>(edits);
    inOrder.sort(Comparator.comparing(Edit::start).thenComparing(Edit::end));
    ByteArrayOutputStream text = new ByteArrayOutputStream();
    int done = 0;
    for (Edit edit : inOrder) {
      text.write(bytes, done, edit.start() - done);
      text.writeBytes(edit.text().getBytes(StandardCharsets.UTF_8));
      done = edit.end();
    }
    text.write(bytes, done, bytes.length - done);
    return text.toString(StandardCharsets.UTF_8);
  }
}
