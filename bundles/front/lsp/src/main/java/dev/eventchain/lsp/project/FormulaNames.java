package dev.eventchain.lsp.project;

import dev.eventchain.editing.Completion;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.Hover;
import dev.eventchain.editing.TextLines;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Names of values in formulas: what is proposed behind a signal, and what is said of it. */
final class FormulaNames {

  private static final String FIELD = "(?<topic>(?:/[A-Za-z_]\\w*)+)\\.(?<path>[A-Za-z_][\\w.]*)";
  private static final Pattern COMPARED =
      Pattern.compile(
          FIELD + "\\s*[=!]=\\s*(?<quote>['\"]?)(?<begun>(?<=['\"])[^'\"=]*|[^'\"=\\s]*)$");
  private static final Pattern READ = Pattern.compile(FIELD);

  private final ProjectFiles project;
  private final String text;
  private final TextLines lines;

  FormulaNames(ProjectFiles project, String text) {
    this.project = project;
    this.text = text;
    this.lines = new TextLines(text);
  }

  /** Returns the names with which the signal before an offset can be compared. */
  List<Completion> at(int offset) {
    Matcher compared = COMPARED.matcher(text.substring(begin(offset), offset));
    if (!compared.find()) {
      return List.of();
    }
    String quote = compared.group("quote");
    int start = begin(offset) + compared.start("begun");
    boolean isClosed = !quote.isEmpty() && text.startsWith(quote, offset);
    return project.valueNames(compared.group("topic"), compared.group("path")).stream()
        .map(
            name ->
                new Completion(
                    name,
                    ElementKind.ENUMERATION_LITERAL,
                    "",
                    "",
                    quote.isEmpty() ? quoted(name) : name + (isClosed ? "" : quote),
                    false,
                    lines.range(start, offset)))
        .toList();
  }

  private static String quoted(String name) {
    return name.contains("'") ? '"' + name + '"' : "'" + name + "'";
  }

  /** Returns the names of the signal's values at an offset; empty if it has none. */
  Optional<Hover> described(int offset) {
    int begin = begin(offset);
    int end = text.indexOf('\n', offset);
    Matcher read = READ.matcher(text).region(begin, end < 0 ? text.length() : end);
    while (read.find()) {
      if (read.start() <= offset && offset <= read.end()) {
        List<String> names = project.valueNames(read.group("topic"), read.group("path"));
        return names.isEmpty()
            ? Optional.empty()
            : Optional.of(
                new Hover(
                    "Its values have names: `" + String.join("`, `", names) + "`.",
                    lines.range(read.start(), read.end())));
      }
    }
    return Optional.empty();
  }

  private int begin(int offset) {
    return offset == 0 ? 0 : text.lastIndexOf('\n', offset - 1) + 1;
  }
}
