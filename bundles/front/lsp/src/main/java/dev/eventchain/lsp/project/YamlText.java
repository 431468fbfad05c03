package dev.eventchain.lsp.project;

import dev.eventchain.lsp.project.YamlLevels.Level;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;

/** A text in YAML, which may be half typed, and what can be written at its places. */
final class YamlText {

  private final String text;

  YamlText(String text) {
    this.text = text;
  }

  /** Returns what can be written at an offset; empty in comments and in texts in lines. */
  Optional<YamlPlace> place(int offset) {
    int begin = offset == 0 ? 0 : text.lastIndexOf('\n', offset - 1) + 1;
    YamlLevels levels = new YamlLevels();
    text.substring(0, begin).lines().forEach(levels::read);
    String line = text.substring(begin, offset);
    int indent = YamlLevels.indent(line);
    boolean isBrackets = levels.isFlow();
    if (levels.isText(indent) || line.startsWith("#") || line.contains(" #")) {
      return Optional.empty();
    }
    int at = isBrackets ? 0 : levels.dashes(line, indent);
    Matcher key = YamlLevels.KEY.matcher(line).region(at, line.length());
    if (isBrackets || key.lookingAt() || line.startsWith("{", at) || line.startsWith("[", at)) {
      levels.read(line);
      return levels.isFlow()
          ? Optional.of(inBrackets(levels, line, begin))
          : isBrackets || !key.lookingAt()
              ? Optional.empty()
              : Optional.of(value(levels, line, begin, key.end()));
    }
    return Optional.of(alone(levels, line, begin, at));
  }

  /**
   * Returns the keys around the text in lines that an offset lies in, behind {@code >} or {@code
   * |}; empty elsewhere.
   */
  Optional<List<String>> textInLines(int offset) {
    int begin = offset == 0 ? 0 : text.lastIndexOf('\n', offset - 1) + 1;
    YamlLevels levels = new YamlLevels();
    text.substring(0, begin).lines().forEach(levels::read);
    return levels.isText(YamlLevels.indent(text.substring(begin, offset)))
        ? Optional.of(levels.path())
        : Optional.empty();
  }

  /**
   * Returns the scalar that a path leads to, if it stands behind its key on a line of its own;
   * empty if there is none.
   */
  String scalar(List<String> path) {
    YamlLevels levels = new YamlLevels();
    for (String line : text.lines().toList()) {
      levels.read(line);
      Matcher key = YamlLevels.KEY.matcher(line).region(YamlLevels.indent(line), line.length());
      if (levels.path().equals(path) && key.lookingAt()) {
        String value = line.substring(key.end()).replaceFirst("\\s#.*", "").strip();
        return YamlLevels.plain(value);
      }
    }
    return "";
  }

  private YamlPlace inBrackets(YamlLevels levels, String line, int begin) {
    Level top = levels.top();
    List<String> path = levels.path();
    boolean isKey = !top.isList && top.key.isEmpty();
    int start = wordStart(line, levels.word());
    return new YamlPlace(
        isKey ? path.subList(0, path.size() - 1) : path,
        isKey ? top.keys : Set.of(),
        isKey,
        !isKey,
        true,
        begin + start,
        wordEnd(begin + line.length()),
        0);
  }

  private YamlPlace value(YamlLevels levels, String line, int begin, int after) {
    return new YamlPlace(
        levels.path(),
        Set.of(),
        false,
        true,
        false,
        begin + wordStart(line, after),
        wordEnd(begin + line.length()),
        0);
  }

  /** Returns a word that may become a key, or is the value of what is further left. */
  private YamlPlace alone(YamlLevels levels, String line, int begin, int at) {
    levels.leave(at, true);
    List<String> path = levels.path();
    Set<String> keys = new HashSet<>(keysBelow(begin, at));
    boolean isInMapping = !levels.isEmpty() && levels.top().column == at;
    if (isInMapping) {
      keys.addAll(levels.top().keys);
      path = path.subList(0, path.size() - 1);
    }
    return new YamlPlace(
        path,
        keys,
        true,
        !isInMapping,
        false,
        begin + wordStart(line, at),
        wordEnd(begin + line.length()),
        at - YamlLevels.indent(line));
  }

  private static int wordStart(String line, int after) {
    int start = after;
    while (start < line.length() && " \"'".indexOf(line.charAt(start)) >= 0) {
      start++;
    }
    return start;
  }

  private int wordEnd(int offset) {
    int end = offset;
    while (end < text.length()
        && !Character.isWhitespace(text.charAt(end))
        && ":,]}\"'#".indexOf(text.charAt(end)) < 0) {
      end++;
    }
    return end;
  }

  /** Returns the keys of the lines below one, up to the end of the mapping at a column. */
  private Set<String> keysBelow(int begin, int column) {
    Set<String> keys = new HashSet<>();
    int next = text.indexOf('\n', begin);
    List<String> below = next < 0 ? List.of() : text.substring(next + 1).lines().toList();
    for (String line : below) {
      int indent = YamlLevels.indent(line);
      boolean isEmpty = line.isBlank() || line.startsWith("#", indent);
      Matcher key = YamlLevels.KEY.matcher(line).region(indent, line.length());
      if (!isEmpty && indent < column) {
        break;
      } else if (!isEmpty && indent == column && key.lookingAt()) {
        keys.add(YamlLevels.plain(key.group(1)));
      }
    }
    return keys;
  }
}
