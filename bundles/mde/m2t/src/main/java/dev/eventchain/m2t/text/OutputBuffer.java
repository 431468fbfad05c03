package dev.eventchain.m2t.text;

import java.util.Optional;

/**
 * The text that a run writes. It grows at one end only: what a called template writes goes where it
 * belongs at once, with the indentation of its caller after every line break; what a file block
 * writes, or a template whose text is wanted as a value, is cut off again.
 */
public final class OutputBuffer {

  /** Where a part of the text starts, and how things were before it. */
  public record Part(int start, String indentation, int lineStart, int lastBreak) {}

  private final StringBuilder text = new StringBuilder(1 << 12);

  /** What is after every line break that is written. */
  private String indentation = "";

  /** Where the current line starts, after that indentation. */
  private int lineStart;

  /** The end of the last line break in the current part, if there is one after its start. */
  private int lastBreak;

  private final OriginMarks marks;

  /**
   * Starts empty.
   *
   * @param marked whether to note where text comes from
   */
  public OutputBuffer(boolean marked) {
    this.marks = marked ? new OriginMarks() : null;
  }

  /** Appends, with the indentation after every line break. */
  public void append(String more) {
    // Java looks for the first one faster, and most texts have none.
    append(more, more.indexOf('\n') >= 0);
  }

  /** The same for text of which is known whether it has a line break. */
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

  /** The same for text of an origin. */
  void append(String more, int origin) {
    marks.add(text.length(), origin);
    if (indentation.isEmpty()) {
      append(more);
    } else {
      appendLines(more, origin);
    }
  }

  /** The same for text whose origins were noted when it was written elsewhere. */
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

  /** About how many characters the text holds, and the indentations of so many calls. */
  public long weight(int calls) {
    return text.length() + (long) indentation.length() * calls / 2;
  }

  /** The white space that the current line starts with. */
  public String currentIndentation() {
    int end = lineStart;
    while (end < text.length() && (text.charAt(end) == ' ' || text.charAt(end) == '\t')) {
      end++;
    }
    return end == lineStart ? "" : text.substring(lineStart, end);
  }

  /** Starts a part that stays where it is, its lines after the first indented by so much more. */
  public Part beginIndented(String more) {
    Part part = begin();
    if (!more.isEmpty()) {
      indentation = indentation.concat(more);
    }
    return part;
  }

  /** Ends a part that stays. */
  public void end(Part part) {
    indentation = part.indentation();
    if (lastBreak > part.start()) {
      lineStart = lastBreak + indentation.length();
    } else {
      lineStart = part.lineStart();
      lastBreak = part.lastBreak();
    }
  }

  /** Starts a part that is a separate text, without any indentation from outside. */
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

  /** Marks the end of the text, to cut off from there what is written next. */
  public Part mark() {
    return new Part(text.length(), indentation, lineStart, lastBreak);
  }

  /** Whether the text has some part of text at an offset. */
  public boolean hasAt(int offset, String part) {
    int end = offset + part.length();
    return end <= text.length() && part.contentEquals(text.subSequence(offset, end));
  }

  /** The text since the start of a part. */
  public String textOf(Part part) {
    return text.substring(part.start());
  }

  /** The origins of the text since the start of a part; empty if origins are not noted. */
  public Optional<OriginMarks> marksOf(Part part) {
    return marks == null ? Optional.empty() : Optional.of(marks.since(part.start()));
  }

  /** Takes away what was written since the start of a part. */
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
