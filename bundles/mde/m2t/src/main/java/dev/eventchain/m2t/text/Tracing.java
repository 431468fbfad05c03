package dev.eventchain.m2t.text;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.generation.GenerationTrace;
import dev.eventchain.m2t.generation.GenerationTrace.Origin;
import dev.eventchain.m2t.generation.GenerationTrace.Segment;
import dev.eventchain.m2t.syntax.Place;
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

/** Collector of the origins of the lines of a run's files. */
public final class Tracing {

  /** A line of a template and the current model element, which is compared by identity. */
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

  /** Origins of each line of a file; open if its last line has no break and can be continued. */
  private static final class Lines {
    private final List<int[]> origins = new ArrayList<>();
    private boolean open;
  }

  private final Function<EObject, SourceLocation> locator;
  private final Map<Key, Integer> numbers = new HashMap<>();
  private final List<Origin> origins = new ArrayList<>();
  private final IdentityHashMap<EObject, SourceLocation> elements = new IdentityHashMap<>();
  private final IdentityHashMap<Expression, SourceLocation> expressions = new IdentityHashMap<>();
  private final IdentityHashMap<Place, SourceLocation> places = new IdentityHashMap<>();
  private final SortedMap<String, Lines> files = new TreeMap<>();

  /** Origins of the current line. */
  private int[] line = new int[16];

  private int lineSize;

  public Tracing(Function<EObject, SourceLocation> locator) {
    this.locator = locator;
  }

  /** Returns the number of an origin: a line of a template with an element or none (null). */
  private int origin(SourceLocation place, int linesBelow, EObject element) {
    int below = place.line() + linesBelow;
    Key key = new Key(place.file(), below, element);
    Integer known = numbers.get(key);
    if (known != null) {
      return known;
    }
    SourceLocation template = new SourceLocation(place.file(), below, 0, "", "");
    origins.add(new Origin(template, locate(element)));
    numbers.put(key, origins.size() - 1);
    return origins.size() - 1;
  }

  /** Returns the number of the origin for a line below a place. */
  int origin(Place place, int linesBelow, EObject element) {
    return origin(places.computeIfAbsent(place, Place::location), linesBelow, element);
  }

  /** Returns the number of the origin for an expression. */
  int origin(Expression expression, EObject element) {
    return origin(expressions.computeIfAbsent(expression, Expression::location), 0, element);
  }

  private SourceLocation locate(EObject element) {
    return element == null ? SourceLocation.NONE : elements.computeIfAbsent(element, locator);
  }

  /** Records the lines of a file, or of text appended to one. */
  public void file(String name, String text, OriginMarks marks) {
    Lines lines = files.computeIfAbsent(name, any -> new Lines());
    int mark = 0;
    for (int start = 0; start < text.length(); ) {
      int lineBreak = text.indexOf('\n', start);
      int end = lineBreak < 0 ? text.length() : lineBreak + 1;
      while (mark + 1 < marks.size() && marks.start(mark + 1) <= start) {
        mark++;
      }
      lineSize = 0;
      for (int i = mark; i < marks.size() && marks.start(i) < end; i++) {
        addToLine(marks.origin(i));
      }
      add(lines);
      lines.open = lineBreak < 0;
      start = end;
    }
  }

  /** Drops a file that another one replaces. */
  void forget(String name) {
    files.remove(name);
  }

  /** Adds the current line, which may continue the last one. */
  private void add(Lines lines) {
    if (lines.open) {
      for (int origin : lines.origins.remove(lines.origins.size() - 1)) {
        addToLine(origin);
      }
      lines.open = false;
    }
    lines.origins.add(Arrays.copyOf(line, lineSize));
  }

  /** Adds an origin to the current line, keeping its origins sorted and distinct. */
  private void addToLine(int origin) {
    if (origin == OriginMarks.NONE) {
      return;
    }
    int at = lineSize;
    while (at > 0 && line[at - 1] > origin) {
      at--;
    }
    if (at > 0 && line[at - 1] == origin) {
      return;
    }
    if (lineSize == line.length) {
      line = Arrays.copyOf(line, lineSize * 2);
    }
    System.arraycopy(line, at, line, at + 1, lineSize - at);
    line[at] = origin;
    lineSize++;
  }

  /** Returns the trace so far. */
  public GenerationTrace result() {
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
    if (numbersOfLine.length == 1) {
      return List.of(origins.get(numbersOfLine[0]));
    }
    return IntStream.of(numbersOfLine).mapToObj(origins::get).sorted().distinct().toList();
  }
}
