package dev.eventchain.documents;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.yaml.snakeyaml.error.Mark;
import org.yaml.snakeyaml.events.AliasEvent;

/**
 * Formatter of YAML that people write. Changes the indentation of lines, spaces at their ends and
 * the end of the file, and nothing else: words, comments, quotes and blank lines stay. The lines of
 * a text, and those of brackets, move with the line on which they begin. Its result has the same
 * values, anchors and comments.
 */
public final class YamlFormatter {

  private static final int DASH = 2;

  /** A mapping or a list that is open, by the column of its lines before and afterwards. */
  private record Level(int before, int after, boolean isList) {}

  private final List<String> lines;
  private final YamlLines parts;
  private final int step;
  private final List<Level> open = new ArrayList<>();
  private final StringBuilder result = new StringBuilder();

  /** The columns by which the line moves on which a text or brackets begin. */
  private int moved;

  private YamlFormatter(List<String> lines, YamlLines parts, int step) {
    this.lines = lines;
    this.parts = parts;
    this.step = step;
  }

  /**
   * Formats a text.
   *
   * @param step the columns by which what is inside a mapping is farther to the right, at least 1
   * @return empty if the text is no YAML, or has keys after question marks or aliases of nothing,
   *     and is left as it is
   */
  public static Optional<String> format(String text, int step) {
    List<String> lines = YamlLines.split(text);
    Optional<YamlLines> parts = YamlLines.of(text, lines.size());
    return parts
        .filter(each -> each.undefinedAlias().isEmpty())
        .flatMap(each -> new YamlFormatter(lines, each, step).run())
        .filter(formatted -> saysTheSame(text, formatted));
  }

  /**
   * Returns the syntax error of a text, which is why it is not formatted; empty if it is YAML.
   *
   * @param rule that of the error
   */
  public static Optional<Diagnostic> syntaxError(SourceText source, Rule rule) {
    Optional<YamlLines> parts = YamlLines.of(source.text(), YamlLines.split(source.text()).size());
    if (parts.isPresent()) {
      return parts.get().undefinedAlias().map(alias -> undefined(alias, source, rule));
    }
    try {
      Document.parseWithAnyText(
          source, DocumentFormat.YAML, DocumentRules.all(rule), problem -> {});
      return Optional.empty(); // readers disagree about where its lines end
    } catch (DiagnosticException e) {
      return Optional.of(e.diagnostics().get(0));
    }
  }

  private static Diagnostic undefined(AliasEvent alias, SourceText source, Rule rule) {
    Mark place = alias.getStartMark();
    String message = "*%1$s stands for nothing: there is no &%1$s in front of it.";
    return Diagnostic.of(
            rule,
            message.formatted(alias.getAnchor()),
            source.at(place.getLine() + 1, place.getColumn() + 1))
        .withHint("Write the value itself, or the anchor where the value is written first.");
  }

  /** Returns whether two texts in YAML have the same values, anchors and styles. */
  public static boolean saysTheSame(String text, String other) {
    Optional<List<String>> values = values(text);
    return values.isPresent() && values.equals(values(other));
  }

  private static Optional<List<String>> values(String text) {
    return YamlLines.of(text, YamlLines.split(text).size()).map(YamlLines::values);
  }

  private Optional<String> run() {
    for (int i = 0; i < lines.size(); i++) {
      String line = lines.get(i);
      String content = content(line);
      if (parts.isInside(i)) {
        result
            .append(moved(content, parts.keepsEnd(i)))
            .append(line, content.length(), line.length());
      } else if (isOdd(content)) {
        return Optional.empty();
      } else {
        String formatted = content.isBlank() ? "" : outside(content, i);
        result.append(parts.keepsEnd(i) ? formatted : formatted.stripTrailing());
        result.append(line, content.length(), line.length());
      }
    }
    return Optional.of(parts.endsInText() ? result.toString() : withOneEnd(result.toString()));
  }

  /** Returns whether a line is indented by tabs, or has a key after a question mark. */
  private static boolean isOdd(String content) {
    String word = content.stripLeading();
    String indent = content.substring(0, content.length() - word.length());
    boolean isTabbed = indent.indexOf('\t') >= 0 && !word.isEmpty();
    return isTabbed || word.matches("(- +)*[?:]( .*)?");
  }

  /** Returns a line without its break. */
  private static String content(String line) {
    int end = line.length();
    while (end > 0 && "\r\n".indexOf(line.charAt(end - 1)) >= 0) {
      end--;
    }
    return line.substring(0, end);
  }

  private static int indent(String content) {
    int indent = 0;
    while (indent < content.length() && content.charAt(indent) == ' ') {
      indent++;
    }
    return indent;
  }

  /** Returns a line of a text or of brackets, which keeps its distance to their beginning. */
  private String moved(String content, boolean keepsEnd) {
    String kept = keepsEnd ? content : content.stripTrailing();
    if (kept.isEmpty()) {
      return kept;
    }
    return moved >= 0 ? " ".repeat(moved) + kept : kept.substring(Math.min(-moved, indent(kept)));
  }

  private String outside(String content, int index) {
    if (content.startsWith("%") || content.startsWith("---") || content.startsWith("...")) {
      open.clear();
      moved = 0;
      return content;
    }
    int indent = indent(content);
    return content.charAt(indent) == '#'
        ? " ".repeat(comment(indent, index)) + content.substring(indent)
        : entry(content, indent);
  }

  /** Returns the column of a comment, which belongs to what begins in the same column. */
  private int comment(int indent, int index) {
    int next = index + 1;
    while (next < lines.size() && isNothing(next)) {
      next++;
    }
    List<Level> levels = new ArrayList<>(open);
    if (next < lines.size() && indent(lines.get(next)) == indent) {
      return enter(levels, indent, isList(lines.get(next), indent));
    }
    return levels.stream()
        .filter(each -> each.before() == indent)
        .findFirst()
        .map(Level::after)
        .orElse(Math.max(0, indent + moved));
  }

  private boolean isNothing(int index) {
    String content = lines.get(index).strip();
    return content.isEmpty() || content.startsWith("#");
  }

  private static boolean isList(String content, int at) {
    boolean dash = content.startsWith("-", at);
    return dash && (at + 1 == content.length() || Character.isWhitespace(content.charAt(at + 1)));
  }

  /** Opens the level of a column, and closes those inside of it; returns the new column. */
  private int enter(List<Level> levels, int column, boolean isList) {
    while (!levels.isEmpty() && isEnded(levels.get(levels.size() - 1), column, isList)) {
      levels.remove(levels.size() - 1);
    }
    Level around = levels.isEmpty() ? null : levels.get(levels.size() - 1);
    if (around != null && around.before() == column && around.isList() == isList) {
      return around.after();
    }
    int after =
        around == null
            ? 0
            : around.before() == column
                ? around.after()
                : around.after() + (around.isList() ? DASH : step);
    levels.add(new Level(column, after, isList));
    return after;
  }

  /** A list may stand in the column of the key that it is the value of, and ends with it. */
  private static boolean isEnded(Level level, int column, boolean isList) {
    return level.before() > column || (level.before() == column && level.isList() && !isList);
  }

  private String entry(String content, int indent) {
    StringBuilder line = new StringBuilder();
    int at = indent;
    int column = enter(open, at, isList(content, at));
    line.append(" ".repeat(column));
    while (isList(content, at)) {
      int next = at + 1;
      while (next < content.length() && content.charAt(next) == ' ') {
        next++;
      }
      boolean isEnd = next == content.length() || "#\t".indexOf(content.charAt(next)) >= 0;
      if (isEnd) {
        break;
      }
      line.append("- ");
      at = next;
      column = enter(open, at, isList(content, at));
    }
    moved = column - at;
    return line + content.substring(at);
  }

  /** Returns a text that ends with one line break. */
  private static String withOneEnd(String text) {
    String stripped = text.stripTrailing();
    if (stripped.isEmpty()) {
      return text;
    }
    String lineBreak = text.contains("\r\n") ? "\r\n" : "\n";
    return stripped + lineBreak;
  }
}
