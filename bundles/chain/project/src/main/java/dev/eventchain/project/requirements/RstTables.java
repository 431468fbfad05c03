package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.CsvRow;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads the tables of reStructuredText: grids, simple ones, lists and CSV. */
final class RstTables {

  private static final Pattern CELL = Pattern.compile("\\s*(\\*)?\\s*(-)(?:\\s+(.*))?");
  private static final String SPANS =
      "Name a cell for each column, and each row on its own; or use a list-table.";

  private final int line;
  private final Map<String, String> options;
  private final List<String> content;
  private final int before;

  /**
   * Creates a reader of the content of a directive.
   *
   * @param line that of the directive
   * @param before the number of lines in front of the content
   */
  RstTables(int line, Map<String, String> options, List<String> content, int before) {
    this.line = line;
    this.options = options;
    this.content = content;
    this.before = before;
  }

  /** Returns whether a line begins a grid or a simple table. */
  static boolean isBorder(String line) {
    return isGrid(line, '-') || isRule(line, '=', 2);
  }

  private static boolean isGrid(String line, char between) {
    String text = line.strip();
    return text.length() > 2
        && text.startsWith("+" + between)
        && text.endsWith(between + "+")
        && text.chars().allMatch(c -> c == '+' || c == between);
  }

  /** Returns whether a line consists of as many lines of one character at least. */
  private static boolean isRule(String line, char of, int columns) {
    String text = line.strip();
    return text.chars().allMatch(c -> c == of || c == ' ')
        && text.split(" +").length >= columns
        && !text.isEmpty();
  }

  /** Reads the table that begins in the next line of a text, and goes on behind it. */
  static void read(RstBlocks text, SourceText source, Reading reading) {
    int first = text.next;
    if (isGrid(text.lines.get(first), '-')) {
      while (text.next < text.lines.size()
          && text.lines.get(text.next).strip().matches("[+|].*[+|]")) {
        text.next++;
      }
      grid(text, first, source, reading);
    } else {
      simple(text, first, source, reading);
    }
  }

  private static void grid(RstBlocks text, int first, SourceText source, Reading reading) {
    String border = text.lines.get(first);
    List<int[]> columns = new ArrayList<>();
    for (int from = border.indexOf('+'), to; (to = border.indexOf('+', from + 1)) > 0; from = to) {
      columns.add(new int[] {from + 1, to});
    }
    Rows rows = new Rows(columns);
    int head = -1;
    for (int i = first + 1; i < text.next; i++) {
      String line = text.lines.get(i);
      boolean isHead = isGrid(line, '=');
      if (isHead || isGrid(line, '-')) {
        rows.end();
        head = isHead ? rows.all.size() : head;
      } else if (columns.stream().anyMatch(each -> at(line, each[1]) != '|')) {
        spans(text, first, i, source, reading);
        return;
      } else {
        rows.add(text.number(i), line);
      }
    }
    rows.end();
    rows.table(text.number(first), Math.max(head, 1)).ifPresent(text.blocks::add);
  }

  /** Reports a table that is not read, if one of its first cells is an id. */
  private static void spans(
      RstBlocks text, int first, int spanned, SourceText source, Reading reading) {
    for (int i = first; i < text.next; i++) {
      String[] cells = text.lines.get(i).strip().split("\\|", 3);
      if (cells.length > 2 && TextIds.isId(cells[1].strip())) {
        reading.unread(
            "A cell of this table spans several columns or rows, which are not read.",
            source.at(text.number(spanned), 1),
            SPANS);
        return;
      }
    }
  }

  private static char at(String line, int index) {
    return index < line.length() ? line.charAt(index) : ' ';
  }

  private static void simple(RstBlocks text, int first, SourceText source, Reading reading) {
    Rows rows = new Rows(columns(text.lines.get(first)));
    int head = -1;
    text.next++;
    for (; text.next < text.lines.size(); text.next++) {
      String line = text.lines.get(text.next);
      if (isRule(line, '=', 2)) {
        rows.end();
        if (head >= 0 || isEnd(text)) {
          break;
        }
        head = rows.all.size();
      } else if (isRule(line, '-', 1)) {
        rows.end();
      } else if (!line.isBlank()) {
        rows.addSimple(text.number(text.next), line);
      }
    }
    checkWidths(text, first, source, reading);
    if (text.next == text.lines.size()) {
      reading.unread(
          "This table has no end.", source.at(text.number(first), 1), "End it with a line of '='.");
    }
    rows.end();
    text.next++;
    rows.table(text.number(first), Math.max(head, 1)).ifPresent(text.blocks::add);
  }

  /** Reports texts that go beyond their column, where a row begins with an id. */
  private static void checkWidths(RstBlocks text, int first, SourceText source, Reading reading) {
    List<int[]> columns = columns(text.lines.get(first));
    int rules = 0;
    boolean named = false;
    for (int i = first; i < Math.min(text.next, text.lines.size()); i++) {
      String line = text.lines.get(i);
      rules += isRule(line, '=', 2) ? 1 : 0;
      if (TextBlocks.indent(line) < columns.get(0)[1]) {
        named = beginsWithId(line);
      }
      if (rules == 2 && named && isWide(line, columns)) {
        reading.unread(
            "A text of this row goes beyond its column.",
            source.at(text.number(i), 1),
            "Make the column wider, by more '=' above and below.");
      }
    }
  }

  private static boolean isWide(String line, List<int[]> columns) {
    for (int i = 1; i < columns.size(); i++) {
      int from = Math.min(columns.get(i - 1)[1], line.length());
      int to = Math.min(columns.get(i)[0], line.length());
      if (!line.substring(from, to).isBlank()) {
        return true;
      }
    }
    return false;
  }

  /** Returns where the columns of a simple table are, of which the last one has no end. */
  private static List<int[]> columns(String border) {
    Matcher columns = Pattern.compile("=+").matcher(border);
    List<int[]> found = new ArrayList<>();
    while (columns.find()) {
      found.add(new int[] {columns.start(), columns.end()});
    }
    found.get(found.size() - 1)[1] = Integer.MAX_VALUE;
    return found;
  }

  private static boolean isEnd(RstBlocks text) {
    return text.next + 1 == text.lines.size() || text.lines.get(text.next + 1).isBlank();
  }

  /** Returns a table whose rows are lists of lists. */
  Optional<TextBlock> ofLists(SourceText source, Reading reading) {
    List<TextBlock.Row> rows = new ArrayList<>();
    List<String> cells = new ArrayList<>();
    int start = 0;
    int mark = 0;
    for (int i = 0; i < content.size(); i++) {
      Matcher cell = CELL.matcher(content.get(i));
      boolean begins = cell.matches() && (cell.group(1) != null || cell.start(2) == mark);
      if (begins && cell.group(1) != null) {
        if (!cells.isEmpty()) {
          rows.add(new TextBlock.Row(start, List.copyOf(cells)));
        }
        cells.clear();
        start = before + i + 1;
        mark = cell.start(2);
      }
      if (begins) {
        cells.add(cell.group(3) == null ? "" : cell.group(3).strip());
      } else if (!content.get(i).isBlank() && !cells.isEmpty()) {
        int last = cells.size() - 1;
        cells.set(last, (cells.get(last) + " " + content.get(i).strip()).strip());
      }
    }
    if (!cells.isEmpty()) {
      rows.add(new TextBlock.Row(start, List.copyOf(cells)));
    }
    return directive(rows, source, reading);
  }

  /** Returns a table in CSV. */
  Optional<TextBlock> ofCsv(SourceText source, Reading reading) {
    List<TextBlock.Row> rows = new ArrayList<>();
    if (!options.getOrDefault("header", "").isBlank()) {
      rows.add(new TextBlock.Row(line, plain(csv(options.get("header")).get(0).cells())));
    }
    if (options.containsKey("file") || options.containsKey("url")) {
      reading.findings.add(
          Diagnostic.of(
                  RequirementRules.UNREAD,
                  "The rows of this table are in another file, which is not read.",
                  source.at(line, 1))
              .withHint("If they are requirements, write them here."));
    }
    if (options.containsKey("delim") && content.stream().anyMatch(RstTables::beginsWithId)) {
      reading.unread(
          "The cells of this table are not divided by commas, which is not read.",
          source.at(line, 1),
          "Divide them by commas, without ':delim:'.");
    }
    String text = String.join("\n", content.stream().map(String::strip).toList());
    for (CsvRow row : csv(text)) {
      rows.add(new TextBlock.Row(before + row.line(), plain(row.cells())));
    }
    return directive(rows, source, reading);
  }

  private static boolean beginsWithId(String text) {
    return TextIds.isId(text.strip().split("[^A-Za-z0-9_./-]", 2)[0]);
  }

  /** Returns the rows of a text, in which quotes may follow blanks. */
  private static List<CsvRow> csv(String text) {
    return CsvRow.rows(text.replaceAll(",[ \t]+\"", ",\""));
  }

  private static List<String> plain(List<String> cells) {
    return cells.stream().map(cell -> cell.replaceAll("\\s+", " ").strip()).toList();
  }

  private Optional<TextBlock> directive(
      List<TextBlock.Row> rows, SourceText source, Reading reading) {
    boolean headed =
        options.containsKey("header") || !options.getOrDefault("header-rows", "0").equals("0");
    boolean named = rows.stream().anyMatch(row -> TextIds.isId(row.cells().get(0)));
    if (!headed && named) {
      reading.unread(
          "This table has no header, so that nobody knows which column holds ids.",
          source.at(line, 1),
          "Say it: ':header-rows: 1'.");
    }
    if (!headed || rows.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new TextBlock.Table(line, rows.get(0).cells(), rows.subList(1, rows.size())));
  }
}
