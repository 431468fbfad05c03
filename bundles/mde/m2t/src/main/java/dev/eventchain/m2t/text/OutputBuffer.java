package dev.eventchain.m2t.text;

import java.util.Optional;

/**
 * Buffer for the text of a run, which only grows at its end. Called templates write directly into
 * it, with the indentation of their caller after every line break. The text of a file block, or of
 * a template used as a value, is cut off again.
 */
public final class OutputBuffer {

  /** The start of a part of the text, and the state before it. */
  public record Part(int start, String indentation, int lineStart, int lastBreak) {}

  private final StringBuilder text = new StringBuilder(1 << 12);

  /** Indentation inserted after every line break. */
  private String indentation = "";

  /** Offset where the current line starts, after that indentation. */
  private int lineStart;

  /** Offset after the last line break in the current part, if there is one. */
  private int lastBreak;

  private final OriginMarks marks;

  /**
   * Creates an empty buffer.
   *
   * @param marked true to record the origins of text
   */
  public OutputBuffer(boolean marked) {
    this.marks = marked ? new OriginMarks() : null;
  }

  /** Appends text, with the indentation after every line break. */
  public void append(String more) {
    // A search for the first line break is faster, and most texts have none.
    append(more, more.indexOf('\n') >= 0);
  }

  /** Appends text of which is known whether it has a line break. */
  void append(String more, boolean hasBreak) {
    if (!hasBreak) {
      text.append(more);
    } else if (indentation.isEmpty()) {
      text.append(more);
      lastBreak = text.length() - (more.length() - more.lastIndexOf('\n') - 1);
      lineStart = lastBreak;
    } else {
      appendLines(more, OriginMarks.NONE);
    }
  }

  /** Appends text of an origin. */
  void append(String more, int origin) {
    marks.add(text.length(), origin);
    if (indentation.isEmpty()) {
      append(more);
    } else {
      appendLines(more, origin);
    }
  }

  /** Appends text whose origins were recorded when it was written elsewhere. */
  public void append(String more, OriginMarks origins) {
    for (int i = 0; i < origins.size(); i++) {
      int end = i + 1 < origins.size() ? origins.start(i + 1) : more.length();
      append(more.substring(origins.start(i), end), origins.origin(i));
    }
  }

  private void appendLines(String more, int origin) {
    int from = 0;
    for (int at = more.indexOf('\n'); at >= 0; at = more.indexOf('\n', from)) {
      text.append(more, from, at + 1);
      lastBreak = text.length();
      if (marks != null) {
        marks.add(text.length(), OriginMarks.NONE);
      }
      text.append(indentation);
      lineStart = text.length();
      if (marks != null) {
        marks.add(text.length(), origin);
      }
      from = at + 1;
    }
    text.append(more, from, more.length());
  }

  /**
   * Returns the approximate number of characters of the text and of the indentations of nested
   * calls.
   */
  public long weight(int calls) {
    return text.length() + (long) indentation.length() * calls / 2;
  }

  /** Returns the leading white space of the current line. */
  public String currentIndentation() {
    int end = lineStart;
    while (end < text.length() && (text.charAt(end) == ' ' || text.charAt(end) == '\t')) {
      end++;
    }
    return end == lineStart ? "" : text.substring(lineStart, end);
  }

  /** Starts a part that stays in place; its lines after the first get additional indentation. */
  public Part beginIndented(String more) {
    Part part = begin();
    if (!more.isEmpty()) {
      indentation = indentation.concat(more);
    }
    return part;
  }

  /** Ends a part that stays in place. */
  public void end(Part part) {
    indentation = part.indentation();
    if (lastBreak > part.start()) {
      lineStart = lastBreak + indentation.length();
    } else {
      lineStart = part.lineStart();
      lastBreak = part.lastBreak();
    }
  }

  /** Starts a part that is a separate text, without outer indentation. */
  public Part beginText() {
    Part part = begin();
    indentation = "";
    return part;
  }

  private Part begin() {
    Part part = mark();
    lineStart = text.length();
    return part;
  }

  /** Marks the end of the text, so that later text can be cut off. */
  public Part mark() {
    return new Part(text.length(), indentation, lineStart, lastBreak);
  }

  /** Returns whether the text contains a part at an offset. */
  public boolean hasAt(int offset, String part) {
    int end = offset + part.length();
    return end <= text.length() && part.contentEquals(text.subSequence(offset, end));
  }

  /** Returns the text since the start of a part. */
  public String textOf(Part part) {
    return text.substring(part.start());
  }

  /**
   * Returns the origins of the text since the start of a part; empty if origins are not recorded.
   */
  public Optional<OriginMarks> marksOf(Part part) {
    return marks == null ? Optional.empty() : Optional.of(marks.since(part.start()));
  }

  /** Removes the text since the start of a part. */
  public void cut(Part part) {
    text.setLength(part.start());
    indentation = part.indentation();
    lineStart = part.lineStart();
    lastBreak = part.lastBreak();
    if (marks != null) {
      marks.cut(part.start());
    }
  }
}
