package dev.eventchain.lsp.project;

import dev.eventchain.editing.SemanticToken;
import dev.eventchain.lsp.project.ProjectSchemas.Kind;
import dev.eventchain.pipeline.ProjectBench.FormulaWord;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The meaning of the words in the YAML of a project: keys, numbers, requirements, topics, comments,
 * and what formulas are made of. Other texts are left to the colours of the editor.
 */
final class YamlTokens {

  /** A string, a number with its unit, or a plain value; up to what divides values in brackets. */
  private static final Pattern ELEMENT =
      Pattern.compile(
          "\"[^\"]*\"|'[^']*'|[^\\s\\[\\]{},\"'][^\\[\\]{},\"']*?(?=\\s*(?:[\\[\\]{},]|:\\s|:?$))");

  /** A word of a formula. */
  private static final Pattern WORD =
      Pattern.compile(
          "'[^']*'|\"[^\"]*\"|(?<topic>(?:/[A-Za-z_]\\w*)+)(?=\\.)|[A-Za-z_][\\w.-]*"
              + "|(?<number>(?<![\\w.])\\d+(?:\\.\\d+)?(?:[eE][+-]?\\d+)?)|[<>=!]=?|[-+*/]");

  private static final Pattern NUMBER = Pattern.compile("[-+]?\\d+(?:\\.\\d+)?(?:[eE][+-]?\\d+)?");
  private static final Pattern TOPIC = Pattern.compile("(?:/[A-Za-z_]\\w*)+");
  private static final Set<String> TRUTHS = Set.of("true", "false", "null");

  private final Optional<Kind> kind;
  private final Set<String> requirements;
  private final Map<String, FormulaWord> formulaWords;
  private final List<SemanticToken> found = new ArrayList<>();
  private final YamlLevels levels = new YamlLevels();
  private int number;

  /**
   * Creates a reading.
   *
   * @param kind that of the file, if it is known
   * @param requirements their ids
   * @param formulaWords operators, which are words, and quantities, with what is said of them
   */
  YamlTokens(Optional<Kind> kind, Set<String> requirements, Map<String, FormulaWord> formulaWords) {
    this.kind = kind;
    this.requirements = requirements;
    this.formulaWords = formulaWords;
  }

  /** Returns the words of a text in its order. */
  List<SemanticToken> of(String text) {
    for (String line : text.split("\r\n|\r|\n", -1)) {
      int indent = YamlLevels.indent(line);
      if (!levels.isText(indent) || line.isBlank()) {
        int comment = comment(line);
        line(line.substring(0, comment), indent);
        if (comment < line.length()) {
          add(comment, line.stripTrailing().length(), SemanticToken.Kind.COMMENT);
        }
      }
      levels.read(line);
      number++;
    }
    return found;
  }

  /** Returns where the comment of a line begins; its end if there is none. */
  private static int comment(String line) {
    char quote = 0;
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      if (quote != 0) {
        quote = c == quote ? 0 : quote;
      } else if ((c == '"' || c == '\'') && (i == 0 || " [{,:-".indexOf(line.charAt(i - 1)) >= 0)) {
        quote = c;
      } else if (c == '#' && (i == 0 || Character.isWhitespace(line.charAt(i - 1)))) {
        return i;
      }
    }
    return line.length();
  }

  private void line(String line, int indent) {
    int at = Math.min(indent, line.length());
    while (line.startsWith("- ", at)) {
      at += 2;
      while (at < line.length() && line.charAt(at) == ' ') {
        at++;
      }
    }
    Matcher key = YamlLevels.KEY.matcher(line).region(at, line.length());
    boolean hasKey = !levels.isFlow() && key.lookingAt();
    if (hasKey) {
      add(
          key.start(1),
          key.end(1),
          named(YamlLevels.plain(key.group(1)), SemanticToken.Kind.PROPERTY));
      at = key.end();
    }
    String value = line.substring(at);
    boolean isFlow = levels.isFlow() || value.strip().matches("[\\[{].*");
    if (hasKey && isFormula(YamlLevels.plain(key.group(1)), isFlow)) {
      formula(line, at);
    } else if (isFlow) {
      elements(line, at);
    } else {
      scalar(line, at, line.length());
    }
  }

  private boolean isFormula(String key, boolean isFlow) {
    return !isFlow
        && (key.equals("formula")
            || (kind.filter(Kind.BENCH::equals).isPresent() && !key.equals("unit")));
  }

  private void elements(String line, int from) {
    Matcher element = ELEMENT.matcher(line).region(from, line.length());
    String before = "";
    while (element.find()) {
      boolean isKey = line.substring(element.end()).matches(":(\\s.*)?");
      String plain = YamlLevels.plain(element.group());
      if (isKey) {
        add(element.start(), element.end(), named(plain, SemanticToken.Kind.PROPERTY));
        before = plain;
      } else if (isFormula(before, false)) {
        formula(line.substring(0, element.end()), element.start());
      } else {
        scalar(line, element.start(), element.end());
      }
    }
  }

  /** Adds a value that is a number, a truth, a topic, or names a requirement. */
  private void scalar(String line, int from, int to) {
    String value = line.substring(from, to).strip();
    int start = line.indexOf(value, from);
    String plain = YamlLevels.plain(value);
    if (NUMBER.matcher(value).matches()) {
      add(start, start + value.length(), SemanticToken.Kind.NUMBER);
    } else if (TRUTHS.contains(value)) {
      add(start, start + value.length(), SemanticToken.Kind.KEYWORD);
    } else if (!plain.isEmpty() && named(plain, null) != null) {
      add(start, start + value.length(), named(plain, null));
    }
  }

  private SemanticToken.Kind named(String word, SemanticToken.Kind otherwise) {
    return requirements.contains(word)
        ? SemanticToken.Kind.ENUMERATION_LITERAL
        : TOPIC.matcher(word).matches() ? SemanticToken.Kind.NAMESPACE : otherwise;
  }

  private void formula(String line, int from) {
    String value = line.substring(from).strip();
    boolean isQuoted = value.length() > 1 && "\"'".indexOf(value.charAt(0)) >= 0;
    int start = line.indexOf(value, from) + (isQuoted ? 1 : 0);
    int end = start + value.length() - (isQuoted ? 2 : 0);
    Matcher word = WORD.matcher(line).region(start, end);
    while (word.find()) {
      formulaKind(word).ifPresent(kindOfIt -> add(word.start(), word.end(), kindOfIt));
    }
  }

  private Optional<SemanticToken.Kind> formulaKind(Matcher word) {
    String text = word.group();
    char first = text.charAt(0);
    if (word.group("topic") != null) {
      return Optional.of(SemanticToken.Kind.NAMESPACE);
    } else if (word.group("number") != null) {
      return Optional.of(SemanticToken.Kind.NUMBER);
    } else if (first == '\'' || first == '"') {
      return Optional.of(SemanticToken.Kind.STRING);
    } else if (!Character.isLetter(first) && first != '_') {
      return Optional.of(SemanticToken.Kind.OPERATOR);
    } else if (requirements.contains(text)) {
      return Optional.of(SemanticToken.Kind.ENUMERATION_LITERAL);
    } else if (TRUTHS.contains(text)) {
      return Optional.of(SemanticToken.Kind.KEYWORD);
    }
    return Optional.ofNullable(formulaWords.get(text))
        .map(it -> it.isOperator() ? SemanticToken.Kind.KEYWORD : SemanticToken.Kind.VARIABLE);
  }

  private void add(int start, int end, SemanticToken.Kind meaning) {
    if (end > start) {
      found.add(new SemanticToken(number, start, end - start, meaning, false));
    }
  }
}
