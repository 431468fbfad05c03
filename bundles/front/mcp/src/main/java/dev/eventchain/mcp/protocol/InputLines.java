package dev.eventchain.mcp.protocol;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;

/** The lines of a stream, each up to a largest length. */
final class InputLines {

  /** Longest line in bytes: a change of a few large files. */
  static final int LONGEST = 4 << 20;

  private final InputStream in;

  InputLines(InputStream in) {
    this.in = in;
  }

  /** A line, or its beginning if it is longer than the limit. */
  static final class Line {

    private final byte[] bytes;
    private final boolean whole;

    private Line(byte[] bytes, boolean whole) {
      this.bytes = bytes;
      this.whole = whole;
    }

    byte[] bytes() {
      return bytes;
    }

    boolean whole() {
      return whole;
    }

    boolean isBlank() {
      for (byte each : bytes) {
        if (each != ' ' && each != '\t' && each != '\r') {
          return false;
        }
      }
      return true;
    }
  }

  /** Returns the next line, also an unfinished last one; empty at the end. */
  Optional<Line> next() throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    boolean whole = true;
    int next = in.read();
    if (next < 0) {
      return Optional.empty();
    }
    for (; next >= 0 && next != '\n'; next = in.read()) {
      if (line.size() < LONGEST) {
        line.write(next);
      } else {
        whole = false;
      }
    }
    return Optional.of(new Line(line.toByteArray(), whole));
  }
}
