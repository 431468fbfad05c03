package dev.eventchain.lsp.project;

import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextLines;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;

/**
 * The keys and the items of lists in YAML, in each other by their indentation: a line that is half
 * typed hides no other. What is in brackets is not divided.
 */
final class YamlOutline {

  /** Most parts in each other. */
  private static final int DEEPEST = 40;

  /** Most characters of a name or a value. */
  private static final int LONGEST = 60;

  /** Keys whose value is the name of an item of a list. */
  private static final Set<String> NAMES = Set.of("name", "id", "scenario");

  private static final String NAMELESS = "-";

  /** A key, or an item of a list. */
  private static final class Part {
    private final int column;
    private final boolean isItem;
    private final int start;
    private final int nameEnd;
    private final List<Part> parts = new ArrayList<>();
    private String name;
    private String value;
    private int end;

    Part(int column, boolean isItem, int start, int nameEnd, String name, String value) {
      this.column = column;
      this.isItem = isItem;
      this.start = start;
      this.nameEnd = nameEnd;
      this.name = name;
      this.value = value;
    }

    Symbol symbol(TextLines lines) {
      return new Symbol(
          name.isBlank() ? NAMELESS : name,
          value,
          isItem ? ElementKind.BLOCK : ElementKind.ATTRIBUTE,
          lines.range(start, Math.max(end, nameEnd)),
          lines.range(start, nameEnd),
          parts.stream().map(each -> each.symbol(lines)).toList());
    }
  }

  private final List<Part> all = new ArrayList<>();
  private final List<Part> open = new ArrayList<>();

  private YamlOutline() {}

  /** Returns the parts of a text in its order. */
  static List<Symbol> of(String text, TextLines lines) {
    YamlOutline outline = new YamlOutline();
    YamlLevels levels = new YamlLevels();
    for (int begin = 0; begin < text.length(); ) {
      int next = text.indexOf('\n', begin);
      int after = next < 0 ? text.length() : next + 1;
      outline.read(text.substring(begin, after).stripTrailing(), begin, levels);
      begin = after;
    }
    return outline.all.stream().map(each -> each.symbol(lines)).toList();
  }

  private void read(String line, int begin, YamlLevels levels) {
    int indent = YamlLevels.indent(line);
    boolean goesOn = levels.isFlow() || levels.isText(indent);
    if (line.startsWith("---") || line.startsWith("...")) {
      open.clear();
    } else if (!line.isBlank() && (goesOn || line.charAt(indent) != '#')) {
      if (!goesOn) {
        content(line, begin, indent);
      }
      open.forEach(each -> each.end = begin + line.length());
    }
    levels.read(line);
  }

  private void content(String line, int begin, int indent) {
    int at = indent;
    while (line.startsWith("- ", at) || (at + 1 == line.length() && line.charAt(at) == '-')) {
      close(at, true);
      add(new Part(at, true, begin + at, begin + line.length(), "", ""));
      at++;
      while (at < line.length() && line.charAt(at) == ' ') {
        at++;
      }
    }
    Matcher key = YamlLevels.KEY.matcher(line).region(at, line.length());
    if (key.lookingAt()) {
      close(at, false);
      String name = YamlLevels.plain(key.group(1));
      String value = value(line.substring(key.end()));
      nameItem(name, value);
      add(new Part(at, false, begin + at, begin + at + key.group(1).length(), name, value));
    } else if (at < line.length() && !open.isEmpty() && open.get(open.size() - 1).isItem) {
      Part item = open.get(open.size() - 1);
      item.name = item.name.isEmpty() ? value(line.substring(at)) : item.name;
    }
  }

  /** Gives the item that a key is in a name: that of its first key, or what says a name. */
  private void nameItem(String key, String value) {
    Part item = open.isEmpty() ? null : open.get(open.size() - 1);
    if (item == null || !item.isItem) {
      return;
    }
    if (NAMES.contains(key) && !value.isEmpty()) {
      item.name = value;
    } else if (item.name.isEmpty()) {
      item.name = value.isEmpty() ? key : shortened(key + ": " + value);
    }
  }

  private static String value(String written) {
    String plain = YamlLevels.plain(written.replaceFirst("(^|\\s)#.*", "").strip());
    return plain.matches("[|>][+-]?\\d?[+-]?") ? "" : shortened(plain);
  }

  private static String shortened(String text) {
    return text.length() <= LONGEST ? text : text.substring(0, LONGEST).stripTrailing() + "…";
  }

  /** Leaves what cannot be around a key, or an item of a list, at a column. */
  private void close(int column, boolean forItem) {
    while (!open.isEmpty()) {
      Part last = open.get(open.size() - 1);
      boolean around = last.column < column || (forItem && last.column == column && !last.isItem);
      if (around) {
        return;
      }
      open.remove(open.size() - 1);
    }
  }

  private void add(Part part) {
    if (open.size() < DEEPEST) {
      (open.isEmpty() ? all : open.get(open.size() - 1).parts).add(part);
      open.add(part);
    }
  }
}
