package dev.eventchain.project.requirements;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads the blocks of a text. Formats add what is neither a paragraph nor an entry of a list. */
abstract class TextBlocks {

  /** An entry of a list, with its text behind the box that it has in a task list. */
  private static final Pattern ENTRY =
      Pattern.compile("\\s*(?:[-*+]|(?:[0-9]+|#)[.)])\\s+((?:\\[[ xX]]\\s+)?(.*))");

  final List<String> lines;
  final List<TextBlock> blocks = new ArrayList<>();
  final int before;
  int next;

  /**
   * Creates a reader.
   *
   * @param before the number of lines in front of these
   */
  TextBlocks(List<String> lines, int before) {
    this.lines = lines;
    this.before = before;
  }

  /** Reads all blocks. */
  final List<TextBlock> read() {
    while (next < lines.size()) {
      if (lines.get(next).isBlank()) {
        next++;
      } else if (!skipCode()) {
        if (isSpecial(next)) {
          special();
        } else {
          plain();
        }
      }
    }
    return blocks;
  }

  /** Goes on behind code that begins in the next line; returns whether there is any. */
  boolean skipCode() {
    return false;
  }

  /** Returns whether an entry of a list begins in a line, which ends a paragraph above it. */
  boolean isEntry(int index) {
    return ENTRY.matcher(lines.get(index)).matches();
  }

  /**
   * Begins an entry of a list.
   *
   * @param content where its text begins in its line
   */
  void enter(String line, int content) {}

  /** Returns whether a block of the format begins in a line, which ends a paragraph above it. */
  abstract boolean isSpecial(int index);

  /** Reads the block of the format that begins in the next line, and goes on behind it. */
  abstract void special();

  private void plain() {
    int first = next;
    Matcher entry = ENTRY.matcher(lines.get(first));
    boolean isEntry = entry.matches();
    if (isEntry) {
      enter(lines.get(first), entry.start(1));
    }
    List<String> own = new ArrayList<>();
    own.add(isEntry ? entry.group(2).strip() : lines.get(first).strip());
    next++;
    while (next < lines.size()
        && !lines.get(next).isBlank()
        && !isSpecial(next)
        && !isEntry(next)) {
      own.add(lines.get(next++).strip());
    }
    blocks.add(new TextBlock.Lines(number(first), indent(lines.get(first)), isEntry, own));
    end(isEntry ? entry.start(1) : indent(lines.get(first)), own.get(own.size() - 1));
  }

  /** Goes on behind what belongs to a paragraph and is no text; its last line may say so. */
  void end(int indent, String last) {}

  /** Returns the number of a line in its file. */
  final int number(int index) {
    return before + index + 1;
  }

  static int indent(String line) {
    return line.length() - line.stripLeading().length();
  }
}
