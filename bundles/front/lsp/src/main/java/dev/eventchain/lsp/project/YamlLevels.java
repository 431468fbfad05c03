package dev.eventchain.lsp.project;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The mappings and lists around a place in YAML. Lines are read one by one, by their indentation:
 * one that is half typed does not hide those around it.
 */
final class YamlLevels {

  /** A key at the place where a match begins, with its colon. */
  static final Pattern KEY =
      Pattern.compile("(\"[^\"]*\"|'[^']*'|[^\\s#{}\\[\\],\"'&*!|>%@-][^#{}\\[\\]]*?):(?=\\s|$)");

  private static final Pattern BLOCK_TEXT = Pattern.compile("[|>][+-]?\\d?[+-]?\\s*(#.*)?");

  private static final int NONE = -1;

  /** A mapping or a list that is open. */
  static final class Level {
    final int column;
    final boolean isList;
    final boolean isFlow;
    final Set<String> keys = new LinkedHashSet<>();
    String key = "";

    Level(int column, boolean isList, boolean isFlow) {
      this.column = column;
      this.isList = isList;
      this.isFlow = isFlow;
    }

    void enter(String name) {
      key = name;
      keys.add(name);
    }
  }

  private final List<Level> open = new ArrayList<>();

  /** The column of what a text in lines belongs to; all lines farther to the right are its own. */
  private int textOf = NONE;

  /** The beginning of the word in brackets at which the reading has stopped. */
  private int word;

  /** Reads a line, or the part of it before the cursor. */
  void read(String line) {
    int indent = indent(line);
    if (isFlow()) {
      flow(line, 0);
    } else if (!isText(line, indent)) {
      textOf = NONE;
      if (line.startsWith("---") || line.startsWith("...")) {
        open.clear();
      } else if (indent < line.length() && line.charAt(indent) != '#') {
        content(line, dashes(line, indent));
      }
    }
  }

  static int indent(String line) {
    int indent = 0;
    while (indent < line.length() && line.charAt(indent) == ' ') {
      indent++;
    }
    return indent;
  }

  private boolean isText(String line, int indent) {
    return textOf != NONE && (indent > textOf || line.isBlank());
  }

  /** Returns whether a line that begins at a column belongs to a text in lines. */
  boolean isText(int column) {
    return textOf != NONE && column > textOf;
  }

  /** Enters the lists whose dashes stand at an offset, and returns where their element begins. */
  int dashes(String line, int offset) {
    int at = offset;
    while (at < line.length()
        && line.charAt(at) == '-'
        && (at + 1 == line.length() || line.charAt(at + 1) == ' ')) {
      leave(at, false);
      if (open.isEmpty() || !top().isList || top().column < at) {
        open.add(new Level(at, true, false));
      }
      at++;
      while (at < line.length() && line.charAt(at) == ' ') {
        at++;
      }
    }
    return at;
  }

  /** Leaves what is farther to the right than a column, and a list at it, if asked to. */
  void leave(int column, boolean lists) {
    while (!open.isEmpty()
        && (top().column > column || (lists && top().column == column && top().isList))) {
      open.remove(open.size() - 1);
    }
  }

  private void content(String line, int at) {
    Matcher key = KEY.matcher(line).region(at, line.length());
    int value = at;
    if (key.lookingAt()) {
      leave(at, true);
      if (open.isEmpty() || top().column < at) {
        open.add(new Level(at, false, false));
      }
      top().enter(plain(key.group(1)));
      value = key.end();
    }
    String text = line.substring(value).strip();
    if (BLOCK_TEXT.matcher(text).matches()) {
      textOf = open.isEmpty() ? 0 : top().column;
    } else if (text.startsWith("{") || text.startsWith("[")) {
      flow(line, line.indexOf(text.charAt(0), value));
    }
  }

  static String plain(String key) {
    return key.length() > 1 && (key.startsWith("\"") || key.startsWith("'"))
        ? key.substring(1, key.length() - 1)
        : key;
  }

  /** Reads brackets, up to the end of the line or that of the outermost ones. */
  private void flow(String line, int start) {
    word = start;
    char quote = 0;
    for (int i = start; i < line.length(); i++) {
      char c = line.charAt(i);
      if (quote != 0) {
        quote = c == quote ? 0 : quote;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '#' && i > 0 && line.charAt(i - 1) == ' ') {
        word = line.length();
        return;
      } else if ("{}[],:".indexOf(c) >= 0) {
        mark(line, i);
        if (!isFlow()) {
          return;
        }
      }
    }
  }

  private void mark(String line, int at) {
    char c = line.charAt(at);
    if (c == '{' || c == '[') {
      open.add(new Level(open.isEmpty() ? 0 : top().column + 1, c == '[', true));
    } else if (c == '}' || c == ']') {
      open.remove(open.size() - 1);
    } else if (c == ',') {
      top().key = "";
    } else if (top().isList || (at + 1 < line.length() && line.charAt(at + 1) != ' ')) {
      return;
    } else {
      top().enter(plain(line.substring(word, at).strip()));
    }
    word = at + 1;
  }

  boolean isFlow() {
    return !open.isEmpty() && top().isFlow;
  }

  /** Returns the offset at which the word in brackets begins that was read last. */
  int word() {
    return word;
  }

  boolean isEmpty() {
    return open.isEmpty();
  }

  /** Returns the innermost mapping or list. */
  Level top() {
    return open.get(open.size() - 1);
  }

  /** Returns the steps to the value that the innermost mapping or list is about. */
  List<String> path() {
    return open.stream().map(each -> each.isList ? YamlPlace.ITEM : each.key).toList();
  }
}
