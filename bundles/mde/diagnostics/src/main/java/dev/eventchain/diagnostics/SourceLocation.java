package dev.eventchain.diagnostics;

import java.nio.file.Path;
import java.util.Comparator;

/**
 * Location in a file.
 *
 * @param file the displayed name of the file, with {@code /} between its parts; empty if there is
 *     none
 * @param line the line, from 1; 0 if unknown
 * @param column the column in characters, from 1; 0 if unknown
 * @param element the element inside the file: a JSON pointer, or the path of a model element; empty
 *     if there is none
 * @param excerpt the whole source line without its line break; empty if unknown
 */
public record SourceLocation(String file, int line, int column, String element, String excerpt)
    implements Comparable<SourceLocation> {

  /** No location. */
  public static final SourceLocation NONE = new SourceLocation("", 0, 0, "", "");

  private static final Comparator<SourceLocation> ORDER =
      Comparator.comparing(SourceLocation::file)
          .thenComparingInt(SourceLocation::line)
          .thenComparingInt(SourceLocation::column)
          .thenComparing(SourceLocation::element)
          .thenComparing(SourceLocation::excerpt);

  /** Returns the location of a whole file. */
  public static SourceLocation of(String file) {
    return new SourceLocation(file, 0, 0, "", "");
  }

  /** Returns the location of a whole file. */
  public static SourceLocation of(Path file) {
    return of(nameOf(file));
  }

  /** Returns the same location in another file, of which this one is a copy. */
  public SourceLocation inFile(Path other) {
    return new SourceLocation(nameOf(other), line, column, element, excerpt);
  }

  /** Returns this location, narrowed to an element. */
  public SourceLocation withElement(String newElement) {
    return new SourceLocation(file, line, column, newElement, excerpt);
  }

  @Override
  public int compareTo(SourceLocation other) {
    return ORDER.compare(this, other);
  }

  /** Returns {@code file:line:column}, without unknown parts; empty for {@link #NONE}. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder(file);
    if (line > 0) {
      text.append(':').append(line);
      if (column > 0) {
        text.append(':').append(column);
      }
    }
    return text.toString();
  }

  /** Returns the displayed name of a file: the same on every system, and for {@code ./x}. */
  public static String nameOf(Path file) {
    String name = file.normalize().toString().replace('\\', '/');
    return name.isEmpty() ? "." : name;
  }
}
