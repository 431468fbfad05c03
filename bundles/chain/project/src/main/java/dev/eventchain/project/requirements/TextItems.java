package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Requirements in texts that people wrote in Markdown or reStructuredText: rows of tables, headings
 * and lines that begin with an id, and directives with one. Ids that a text mentions, but that are
 * none of an item, are findings.
 */
final class TextItems {

  /** Greatest number of characters of a line. */
  private static final int LONGEST_LINE = 10_000;

  private final Reading reading;
  private final RstFiles files;
  private final TextKinds kinds;
  private final TextForms forms = new TextForms();
  private final List<Text> texts = new ArrayList<>();
  private final List<SourceText> read = new ArrayList<>();
  private final List<Mentioned> mentioned = new ArrayList<>();
  private final Set<String> places = new HashSet<>();
  private final Set<String> known = new HashSet<>();
  private final Set<String> prefixes = new TreeSet<>();

  /** A text, and what it consists of. */
  private record Text(SourceText source, List<TextBlock> blocks) {}

  /** Id of a row without a text. */
  private record Mentioned(String id, SourceText source, int line) {}

  TextItems(Reading reading, RstFiles files) {
    this.reading = reading;
    this.files = files;
    this.kinds = new TextKinds(reading);
  }

  /** Reads a text, which is read once. */
  void read(Path file, SourceText source) {
    boolean markdown = source.name().toLowerCase(Locale.ROOT).endsWith(".md");
    List<String> lines = lines(source);
    TextBlocks blocks =
        markdown
            ? new MarkdownBlocks(lines, 0)
            : new RstBlocks(lines, new RstFiles.Open(source, file), files, reading);
    Text text = new Text(source, blocks.read());
    texts.add(text);
    keep(text.blocks());
    read.add(source);
    kinds.see(text.blocks());
    forms.see(source, text.blocks());
  }

  private void keep(List<TextBlock> blocks) {
    for (TextBlock block : blocks) {
      if (block instanceof TextBlock.Included included) {
        read.add(included.source());
        keep(included.blocks());
      }
    }
  }

  /**
   * Returns the lines of a text.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if one is too long
   */
  static List<String> lines(SourceText source) {
    List<String> lines = new ArrayList<>(source.text().lines().toList());
    for (int i = 0; i < lines.size(); i++) {
      if (lines.get(i).length() > LONGEST_LINE) {
        String message =
            String.format(Locale.ROOT, "This line has more than %d characters.", LONGEST_LINE);
        throw Reading.refused(message, source.at(i + 1, 1), "Divide it.");
      }
    }
    return lines;
  }

  private void add(Text text) {
    TextOutline outline = new TextOutline(text.source(), kinds, reading);
    add(text.blocks(), outline);
    outline.items().forEach(this::add);
  }

  private void add(List<TextBlock> blocks, TextOutline outline) {
    for (TextBlock block : blocks) {
      if (block instanceof TextBlock.Table table) {
        table(table, outline.source(), outline);
      } else if (block instanceof TextBlock.Included included) {
        SourceText around = outline.source();
        outline.goTo(included.source());
        add(included.blocks(), outline);
        outline.goTo(around);
      } else {
        outline.add(block);
      }
    }
  }

  /** Adds an item, unless a file with it was taken in before. */
  private void add(Item item) {
    if (!places.add(item.location + " " + item.id)) {
      return;
    }
    known.add(plain(item.id));
    Optional<String> kind = TextIds.prefix(item.id);
    kind.ifPresent(prefixes::add);
    if (item.type.isEmpty()) {
      item.type = kind;
    } else {
      item.generalTypes = kind.map(Set::of).orElse(Set.of());
    }
    reading.items.add(item);
  }

  private void table(TextBlock.Table table, SourceText source, TextOutline outline) {
    TableColumns columns = new TableColumns(table, reading.fields);
    if (!columns.hasIds()) {
      outline.add(table);
    } else if (!columns.ambiguous().isEmpty()) {
      reading.unread(
          "Several columns of this table may hold the text: '%s'."
              .formatted(String.join("', '", columns.ambiguous())),
          source.at(table.line(), 1),
          "Say which in eventchain.yaml: fields: {text: NAME}.");
    } else {
      table.rows().forEach(row -> row(row, columns, source, outline));
    }
  }

  private void row(
      TextBlock.Row row, TableColumns columns, SourceText source, TextOutline outline) {
    String id = columns.id(row);
    if (columns.isTooLong(row)) {
      reading.unread(
          "This row has more cells than its header.",
          source.at(row.line(), 1),
          "Write a bar that belongs to a text as \\|.");
    } else if (!columns.hasTexts()) {
      mentioned.add(new Mentioned(id, source, row.line()));
    } else if (columns.isTitle(row) && !TextIds.isId(id)) {
      if (!id.isEmpty()) {
        find("This row has no text, and is taken for a heading.", source, row.line());
      }
    } else if (id.contains(" ")) {
      reading.unread(
          "'%s' is no id of a requirement.".formatted(id),
          source.at(row.line(), 1),
          "Write an id without blanks, such as REQ-1.");
    } else {
      Item item = new Item(id, columns.text(row), source.at(row.line(), 1));
      columns.describe(row, item, item.location);
      outline.add(item);
    }
  }

  /** Adds the items of all texts, and finds ids that are none of an item. */
  void end() {
    texts.forEach(this::add);
    kinds.report();
    forms.report(reading, known, prefixes);
    for (Mentioned each : mentioned) {
      if (TextIds.isId(each.id()) && known.add(plain(each.id()))) {
        find("No item has the id '" + each.id() + "'.", each.source(), each.line());
      }
    }
    if (known.isEmpty() && !texts.isEmpty()) {
      reading.unread(
          "There is no requirement in this text.",
          texts.get(0).source().at(0),
          "Write a table with columns 'ID' and 'Text', headings '### REQ-1 Title' or items '- REQ-1: text'.");
    }
    if (!prefixes.isEmpty()) {
      findMentioned();
    }
  }

  private void findMentioned() {
    String any = String.join("|", prefixes.stream().map(Pattern::quote).toList());
    Pattern id =
        Pattern.compile(
            "(?<![A-Za-z0-9_./-])(?:" + any + ")[-_./]?[0-9]{1,20}(?:\\.[0-9]{1,20}){0,8}");
    for (SourceText source : read) {
      Matcher found = id.matcher(source.text());
      while (found.find()) {
        if (known.add(plain(found.group()))) {
          reading.findings.add(
              unread("No item has the id '" + found.group() + "'.")
                  .withLocation(source.at(found.start())));
        }
      }
    }
  }

  private static String plain(String id) {
    return id.toLowerCase(Locale.ROOT);
  }

  private void find(String message, SourceText source, int line) {
    reading.findings.add(unread(message).withLocation(source.at(line, 1)));
  }

  private static Diagnostic unread(String message) {
    return Diagnostic.of(RequirementRules.UNREAD, message, SourceLocation.NONE)
        .withHint(
            "If it should be one, write a row with an id and a text, a heading '### ID Title' or an"
                + " item '- ID: text'.");
  }
}
