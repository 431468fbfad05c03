package dev.eventchain.m2t;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.GenerationTrace.Origin;
import dev.eventchain.m2t.GenerationTrace.Segment;
import dev.eventchain.ocl.Expression;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.eclipse.emf.ecore.EObject;

/** Collects where the lines of a run's files come from. */
final class Tracing {

  /** A line of a template, and the model element at work; compared by identity. */
  private record Key(String file, int line, EObject element) {
    @Override
    public boolean equals(Object other) {
      return other instanceof Key key
          && line == key.line
          && element == key.element
          && file.equals(key.file);
    }

    @Override
    public int hashCode() {
      return (file.hashCode() * 31 + line) * 31 + System.identityHashCode(element);
    }
  }

  /** The origins of each line of a file; a file that does not end with a break can be gone on. */
  private static final class Lines {
    private final List<int[]> origins = new ArrayList<>();
    private boolean open;
  }

  private final Function<EObject, SourceLocation> locator;
  private final Map<Key, Integer> numbers = new HashMap<>();
  private final List<Origin> origins = new ArrayList<>();
  private final IdentityHashMap<EObject, SourceLocation> elements = new IdentityHashMap<>();
  private final IdentityHashMap<Expression, SourceLocation> expressions = new IdentityHashMap<>();
  private final SortedMap<String, Lines> files = new TreeMap<>();

  Tracing(Function<EObject, SourceLocation> locator) {
    this.locator = locator;
  }

  /** The number of an origin: a line of a template, at work on an element or on none (null). */
  int origin(SourceLocation place, int linesBelow, EObject element) {
    int line = place.line() + linesBelow;
    return numbers.computeIfAbsent(
        new Key(place.file(), line, element),
        key -> {
          SourceLocation template = new SourceLocation(place.file(), line, 0, "", "");
          origins.add(new Origin(template, locate(element)));
          return origins.size() - 1;
        });
  }

  /** The number of the origin that an expression is. */
  int origin(Expression expression, EObject element) {
    return origin(expressions.computeIfAbsent(expression, Expression::location), 0, element);
  }

  private SourceLocation locate(EObject element) {
    return element == null ? SourceLocation.NONE : elements.computeIfAbsent(element, locator);
  }

  /** Notes the lines of a file, or of what is appended to one. */
  void file(String name, String text, OriginMarks marks) {
    Lines lines = files.computeIfAbsent(name, any -> new Lines());
    int mark = 0;
    for (int start = 0; start < text.length(); ) {
      int lineBreak = text.indexOf('\n', start);
      int end = lineBreak < 0 ? text.length() : lineBreak + 1;
      while (mark + 1 < marks.size() && marks.start(mark + 1) <= start) {
        mark++;
      }
      IntStream.Builder found = IntStream.builder();
      for (int i = mark; i < marks.size() && marks.start(i) < end; i++) {
        if (marks.origin(i) != OriginMarks.NONE) {
          found.add(marks.origin(i));
        }
      }
      add(found.build(), lines);
      lines.open = lineBreak < 0;
      start = end;
    }
  }

  private static void add(IntStream line, Lines lines) {
    IntStream all = line;
    if (lines.open) {
      all = IntStream.concat(all, IntStream.of(lines.origins.remove(lines.origins.size() - 1)));
      lines.open = false;
    }
    lines.origins.add(all.sorted().distinct().toArray());
  }

  /** The trace of everything so far. */
  GenerationTrace result() {
    SortedMap<String, List<Segment>> segments = new TreeMap<>();
    files.forEach((name, lines) -> segments.put(name, segments(lines.origins)));
    return new GenerationTrace(segments);
  }

  private List<Segment> segments(List<int[]> lines) {
    List<Segment> segments = new ArrayList<>();
    int first = 0;
    for (int i = 1; i <= lines.size(); i++) {
      if (i == lines.size() || !Arrays.equals(lines.get(first), lines.get(i))) {
        if (lines.get(first).length > 0) {
          segments.add(new Segment(first + 1, i, origins(lines.get(first))));
        }
        first = i;
      }
    }
    return segments;
  }

  private List<Origin> origins(int[] numbersOfLine) {
    return IntStream.of(numbersOfLine).mapToObj(origins::get).sorted().distinct().toList();
  }
}
