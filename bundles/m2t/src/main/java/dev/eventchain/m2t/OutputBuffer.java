package dev.eventchain.m2t;

/** Text in the making, which knows the indentation of its last line. */
final class OutputBuffer {
  private final StringBuilder text = new StringBuilder();
  private int floor;

  void append(String more) {
    text.append(more);
  }

  /** Appends, with the white space that the current line starts with after every line break. */
  void appendIndented(String more) {
    int lineBreak = more.indexOf('\n');
    String indentation = lineBreak < 0 ? "" : indentation();
    if (indentation.isEmpty()) {
      text.append(more);
      return;
    }
    int from = 0;
    while (lineBreak >= 0) {
      text.append(more, from, lineBreak + 1).append(indentation);
      from = lineBreak + 1;
      lineBreak = more.indexOf('\n', from);
    }
    text.append(more, from, more.length());
  }

  /** Takes away again what something writes, and returns it. Its first line starts a new text. */
  String capture(Runnable writer) {
    int outerFloor = floor;
    int start = text.length();
    floor = start;
    try {
      writer.run();
      return text.substring(start);
    } finally {
      text.setLength(start);
      floor = outerFloor;
    }
  }

  private String indentation() {
    int start = text.length();
    while (start > floor && text.charAt(start - 1) != '\n') {
      start--;
    }
    int end = start;
    while (end < text.length() && (text.charAt(end) == ' ' || text.charAt(end) == '\t')) {
      end++;
    }
    return text.substring(start, end);
  }
}
