package dev.eventchain.project.requirements;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Reads the headings, tables, lists and paragraphs of Markdown. */
final class MarkdownBlocks extends TextBlocks {

  private static final Pattern HEADING = Pattern.compile(" {0,3}(#{1,6}+)\\s+(.*)");
  private static final Pattern FENCE = Pattern.compile("\\s*(```+(?=[^`]*$)|~~~+).*");
  private static final Pattern UNDERLINE = Pattern.compile(" {0,3}(=+|-{3,})\\s*");
  private static final Pattern BAR = Pattern.compile("(?<!\\\\)\\|");

  /** Admonitions and tabs of MkDocs, whose content is indented by as much as code. */
  private static final Pattern INDENTED =
      Pattern.compile("\\s*(?:!!!|\\?\\?\\?\\+?|===[!+]?)\\s+[\"A-Za-z].*");

  /** Columns by which code is indented, and to which tabs lead. */
  private static final int CODE = 4;

  /** Columns at which the texts begin of the entries that are open, the outermost first. */
  private final Deque<Integer> entries = new ArrayDeque<>();

  MarkdownBlocks(List<String> lines, int before) {
    super(lines, before);
  }

  /** Skips code by its indent, which counts from the text of the entry that it belongs to. */
  @Override
  boolean skipCode() {
    int column = column(lines.get(next), indent(lines.get(next)));
    while (!entries.isEmpty() && entries.peekLast() > column) {
      entries.removeLast();
    }
    if (!isCode(next)) {
      return false;
    }
    int least = around(column) + CODE;
    while (next < lines.size()
        && (lines.get(next).isBlank()
            || column(lines.get(next), indent(lines.get(next))) >= least)) {
      next++;
    }
    return true;
  }

  @Override
  boolean isEntry(int index) {
    return super.isEntry(index) && !isCode(index);
  }

  @Override
  void enter(String line, int content) {
    int mark = line.substring(0, content).stripTrailing().length();
    boolean isCode = column(line, content) - column(line, mark) > CODE;
    entries.addLast(isCode ? column(line, mark) + 1 : column(line, content));
  }

  private boolean isCode(int index) {
    int column = column(lines.get(index), indent(lines.get(index)));
    return column - around(column) >= CODE;
  }

  /** Returns where the text begins of the innermost entry that a line may belong to; else 0. */
  private int around(int column) {
    int found = 0;
    for (int each : entries) {
      found = each <= column ? each : found;
    }
    return found;
  }

  /** Returns the column of a character in a line, with its tabs. */
  private static int column(String line, int at) {
    int column = 0;
    for (int i = 0; i < at; i++) {
      column += line.charAt(i) == '\t' ? CODE - column % CODE : 1;
    }
    return column;
  }

  @Override
  boolean isSpecial(int index) {
    String line = lines.get(index);
    return HEADING.matcher(line).matches()
        || FENCE.matcher(line).matches()
        || line.stripLeading().startsWith("<!--")
        || isIndented(index)
        || isTable(index)
        || isUnderlined(index);
  }

  private boolean isIndented(int index) {
    return INDENTED.matcher(lines.get(index)).matches() && !isCode(index);
  }

  private boolean isTable(int index) {
    return index + 1 < lines.size()
        && lines.get(index).contains("|")
        && lines.get(index + 1).contains("|")
        && lines.get(index + 1).contains("-")
        && lines.get(index + 1).chars().allMatch(c -> " \t|:-".indexOf(c) >= 0);
  }

  private boolean isUnderlined(int index) {
    return index + 1 < lines.size()
        && !lines.get(index).matches("\\s*([-*+>|].*)?")
        && UNDERLINE.matcher(lines.get(index + 1)).matches();
  }

  @Override
  void special() {
    Matcher heading = HEADING.matcher(lines.get(next));
    Matcher fence = FENCE.matcher(lines.get(next));
    if (heading.matches()) {
      int level = heading.group(1).length();
      String text = TextIds.withoutEnd(heading.group(2), "#");
      blocks.add(new TextBlock.Heading(number(next++), level, text));
    } else if (fence.matches()) {
      skipTo(fence.group(1));
    } else if (isIndented(next)) {
      int indent = indent(lines.get(next));
      entries.addLast(column(lines.get(next), indent) + CODE);
      String text = lines.get(next).strip();
      blocks.add(new TextBlock.Lines(number(next++), indent, false, List.of(text)));
    } else if (isTable(next)) {
      table();
    } else if (isUnderlined(next)) {
      int level = lines.get(next + 1).contains("=") ? 1 : 2;
      blocks.add(new TextBlock.Heading(number(next), level, lines.get(next).strip()));
      next += 2;
    } else {
      skipComment();
    }
  }

  private void skipTo(String end) {
    next++;
    while (next < lines.size() && !lines.get(next).strip().startsWith(end)) {
      next++;
    }
    next++;
  }

  private void skipComment() {
    while (next < lines.size() && !lines.get(next).contains("-->")) {
      next++;
    }
    next++;
  }

  private void table() {
    int first = next;
    List<String> header = cells(lines.get(first));
    List<TextBlock.Row> rows = new ArrayList<>();
    next += 2;
    while (next < lines.size() && lines.get(next).contains("|")) {
      rows.add(new TextBlock.Row(number(next), cells(lines.get(next))));
      next++;
    }
    blocks.add(new TextBlock.Table(number(first), header, rows));
  }

  /** Returns the cells of a row; bars with a backslash in front are text. */
  private static List<String> cells(String line) {
    String inner = line.strip().replaceFirst("^\\|", "").replaceFirst("(?<!\\\\)\\|$", "");
    return Stream.of(BAR.split(inner, -1))
        .map(cell -> cell.replace("\\|", "|").replaceAll("(?i)<br\\s*/?>", " ").strip())
        .toList();
  }
}
