package dev.eventchain.m2t.generation;

import dev.eventchain.diagnostics.SourceLocation;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Which template lines and which model elements made which lines of the generated files. Immutable.
 *
 * <p>A character's origin is the line of the template that its text is on, or that the tag is on
 * whose expression gave it; so a called template's lines count, and not the call's. What a {@code
 * post} expression gives keeps its origins if it is a part of the template's text, as after {@code
 * trim()}; otherwise all of it comes from the line of the {@code post} expression. The same holds
 * for a template whose text an expression works on, as in {@code x.name().toUpper()}: it comes from
 * the line of that tag. The element is the innermost {@code self} that is a model element.
 * Indentation that a call adds has no origin.
 */
public final class GenerationTrace {

  /** The trace of a generation that noted nothing. */
  public static final GenerationTrace NONE = new GenerationTrace(Collections.emptySortedMap());

  /**
   * What made some text.
   *
   * @param template the file of the template, and the line
   * @param element the model element, as the generation's locator told where it is; {@link
   *     SourceLocation#NONE} if there was none
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
   * @param origins sorted, each once, at least one
   */
  public record Segment(int firstLine, int lastLine, List<Origin> origins) {

    /** Takes a copy. */
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
   * The lines of each file by its name relative to the output folder, in order; lines that the
   * generation did not write, inside protected areas that were kept, are left out. Empty unless the
   * generation was {@linkplain GenerationContext#withTrace() told} to trace.
   */
  public SortedMap<String, List<Segment>> files() {
    return files;
  }
}
