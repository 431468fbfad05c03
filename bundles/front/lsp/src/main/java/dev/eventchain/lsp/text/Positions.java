package dev.eventchain.lsp.text;

import dev.eventchain.editing.TextPosition;
import dev.eventchain.editing.TextRange;
import java.net.URI;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.IntPredicate;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;

/** Places of the protocol, and those of the engine, which counts lines and columns alike. */
public final class Positions {

  private Positions() {}

  /** Returns a position of the engine. */
  public static TextPosition of(Position position) {
    return new TextPosition(position.getLine(), position.getCharacter());
  }

  /** Returns a position of the protocol. */
  public static Position of(TextPosition position) {
    return new Position(position.line(), position.column());
  }

  /** Returns a range of the engine. */
  public static TextRange of(Range range) {
    return new TextRange(of(range.getStart()), of(range.getEnd()));
  }

  /** Returns a range of the protocol. */
  public static Range of(TextRange range) {
    return new Range(of(range.start()), of(range.end()));
  }

  /** Returns whether a range has a part of a line, or is at it, by the number of the line. */
  public static IntPredicate lines(Range range) {
    int first = range.getStart().getLine();
    int last = range.getEnd().getLine();
    boolean atStart = range.getEnd().getCharacter() == 0 && last > first;
    return line -> first <= line && line <= (atStart ? last - 1 : last);
  }

  /** Returns a position some columns further, if it is on the first line. */
  public static TextPosition shifted(TextPosition position, int columns) {
    return position.line() == 0 && columns != 0
        ? new TextPosition(0, Math.max(0, position.column() + columns))
        : position;
  }

  /** Returns a range some columns further, as far as it is on the first line. */
  public static TextRange shifted(TextRange range, int columns) {
    return new TextRange(shifted(range.start(), columns), shifted(range.end(), columns));
  }

  /** Returns the path of a file's address; empty if it is not about a file on this machine. */
  public static Optional<Path> path(String uri) {
    try {
      // Some clients escape neither spaces nor letters beyond ASCII.
      URI address = URI.create(URI.create(uri.replace(" ", "%20")).toASCIIString());
      if (!"file".equalsIgnoreCase(address.getScheme())) {
        return Optional.empty();
      }
      URI local = "localhost".equals(address.getAuthority()) ? withoutHost(address) : address;
      return Optional.of(Path.of(local).toAbsolutePath().normalize());
    } catch (IllegalArgumentException | FileSystemNotFoundException e) {
      return Optional.empty();
    }
  }

  private static URI withoutHost(URI address) {
    return URI.create("file://" + address.getRawPath());
  }
}
