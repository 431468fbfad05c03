package dev.eventchain.m2t.generation;

import dev.eventchain.diagnostics.SourceLocation;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Trace of the lines of generated files to template lines and model elements. Immutable.
 *
 * <p>The origin of a character is the template line of its text, or of the tag whose expression
 * produced it. Lines of a called template count, not the line of the call. If the result of a
 * {@code post} expression is a part of the template's text, as after {@code trim()}, it keeps its
 * origins; otherwise its origin is the line of the {@code post} expression. Likewise, if an
 * expression processes the text of a template, as in {@code x.name().toUpper()}, the origin is the
 * line of that tag. The element is the innermost {@code self} that is a model element. Indentation
 * that a call adds has no origin.
 */
public final class GenerationTrace {

  /** Empty trace of a generation without tracing. */
  public static final GenerationTrace NONE = new GenerationTrace(Collections.emptySortedMap());

  /**
   * Origin of some text.
   *
   * @param template the template file and the line
   * @param element the location of the model element by the generation's locator; {@link
   *     SourceLocation#NONE} if there is none
   */
  public record Origin(SourceLocation template, SourceLocation element)
      implements Comparable<Origin> {
    private static final Comparator<Origin> ORDER =
        Comparator.comparing(Origin::template).thenComparing(Origin::element);

    @Override
    public int compareTo(Origin other) {
      return ORDER.compare(this, other);
    }
  }

  /**
   * Lines with the same origins.
   *
   * @param firstLine the first of them, from 1
   * @param lastLine the last of them
   * @param origins the distinct origins, sorted; at least one
   */
  public record Segment(int firstLine, int lastLine, List<Origin> origins) {

    /** Copies the origins. */
    public Segment {
      origins = List.copyOf(origins);
    }
  }

  private final SortedMap<String, List<Segment>> files;

  public GenerationTrace(SortedMap<String, List<Segment>> files) {
    SortedMap<String, List<Segment>> copy = new TreeMap<>();
    files.forEach((name, segments) -> copy.put(name, List.copyOf(segments)));
    this.files = Collections.unmodifiableSortedMap(copy);
  }

  /**
   * Returns the lines of each file by its name relative to the output folder, in order, without
   * lines inside kept protected areas. Empty unless the generation was {@linkplain
   * GenerationContext#withTrace() told} to trace.
   */
  public SortedMap<String, List<Segment>> files() {
    return files;
  }
}
