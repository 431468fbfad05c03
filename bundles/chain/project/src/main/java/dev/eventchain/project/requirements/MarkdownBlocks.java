package dev.eventchain.project.requirements;

import java.util.ArrayList;
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

  MarkdownBlocks(List<String> lines) {
    super(lines, 0);
  }

  @Override
  boolean isSpecial(int index) {
    String line = lines.get(index);
    return HEADING.matcher(line).matches()
        || FENCE.matcher(line).matches()
        || line.stripLeading().startsWith("<!--")
        || isTable(index)
        || isUnderlined(index);
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
