package dev.eventchain.lsp.project;

import dev.eventchain.editing.Completion;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.Hover;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextRange;
import dev.eventchain.lsp.project.ProjectSchemas.Kind;
import dev.eventchain.pipeline.ProjectBench;
import dev.eventchain.pipeline.ProjectBench.FormulaWord;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Names of values in formulas: what is proposed behind a signal, and what is said of it. */
final class FormulaNames {

  private static final String FIELD = "(?<topic>(?:/[A-Za-z_]\\w*)+)\\.(?<path>[A-Za-z_][\\w.]*)";
  private static final Pattern COMPARED =
      Pattern.compile(
          FIELD + "\\s*[=!]=\\s*(?<quote>['\"]?)(?<begun>(?<=['\"])[^'\"=\n]*|[^'\"=\\s]*)\\z");
  private static final Pattern READ = Pattern.compile(FIELD);

  /** An operator or a quantity of the world. */
  private static final Pattern WORD =
      Pattern.compile("(?<![\\w.])[A-Za-z_]\\w*(?:\\.[A-Za-z_]\\w*)*");

  private static final Pattern NAMED = Pattern.compile(FIELD + "|" + WORD.pattern());

  /** A number, and what is begun of its unit. */
  private static final Pattern NUMBER =
      Pattern.compile(
          "(?<![\\w.])\\d[\\d.]*(?:[eE][-+]?\\d+)?(?:\\s+|(?=[A-Za-z%]))(?<begun>%?|[A-Za-z][\\w/^]*)\\z");

  /** A unit as a formula takes it behind a number. */
  private static final Pattern UNIT = Pattern.compile("%|[A-Za-z][\\w/]*");

  /** The beginning of an interval, whose numbers are times. */
  private static final Pattern INTERVAL = Pattern.compile("\\[[^\\[\\](){}:]*\\z");

  private static final String SECOND = "s";

  /** Text before the words of a formula on its line, in scenarios and campaigns. */
  private static final Pattern FORMULA = Pattern.compile("[^#]*\\bformula: .*");

  /** The keys around a formula of a bench: a field that is sent, or an input. */
  private static final Pattern SOURCE =
      Pattern.compile(
          "provides\n[^\n]*\nfields\n[^\n]*(\nvalue)?|inputs\n[^\n]*(\n(formula|value))?");

  /** Most fields that are proposed at once. */
  private static final int MOST = 200;

  private static final Pattern BEGUN = Pattern.compile("(?<![\\w/.'\"])(?:[A-Za-z_/][\\w/.]*)?$");

  static final Map<String, FormulaWord> WORDS = ProjectBench.formulaWords();

  private final ProjectFiles project;
  private final String text;
  private final TextLines lines;
  private final Kind kind;
  private final boolean isBench;

  /**
   * Creates the names of a text.
   *
   * @param kind that of its file: in a bench, inputs and the sources of fields are formulas
   */
  FormulaNames(ProjectFiles project, String text, Kind kind) {
    this.project = project;
    this.text = text;
    this.kind = kind;
    this.isBench = kind == Kind.BENCH;
    this.lines = new TextLines(text);
  }

  private boolean isFormula(int offset) {
    YamlText yaml = new YamlText(text);
    Optional<List<String>> inLines = yaml.textInLines(offset);
    if (isBench) {
      return inLines
          .or(() -> yaml.place(offset).filter(YamlPlace::takesValue).map(YamlPlace::path))
          .filter(path -> SOURCE.matcher(String.join("\n", path)).matches())
          .isPresent();
    }
    return inLines
        .map(path -> !path.isEmpty() && path.get(path.size() - 1).equals("formula"))
        .orElseGet(() -> FORMULA.matcher(text.substring(begin(offset), offset)).matches());
  }

  /** Returns the names with which the signal before an offset can be compared. */
  List<Completion> compared(int offset) {
    // A text in lines may have the signal on the line before.
    int from = new YamlText(text).textInLines(offset).isPresent() ? 0 : begin(offset);
    Matcher compared = COMPARED.matcher(text.substring(from, offset));
    if (!compared.find()) {
      return List.of();
    }
    String quote = compared.group("quote");
    int start = from + compared.start("begun");
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

  /** Returns the signals, quantities, operators and units of a formula. */
  List<Completion> words(int offset) {
    return Stream.concat(units(offset).stream(), names(offset).stream()).toList();
  }

  /** Returns the units of a number before an offset; formulas of campaigns have none. */
  private List<Completion> units(int offset) {
    Matcher number = NUMBER.matcher(text.substring(begin(offset), offset));
    if (kind == Kind.CAMPAIGN || !number.find() || !isFormula(begin(offset) + number.start())) {
      return List.of();
    }
    TextRange replaced = lines.range(begin(offset) + number.start("begun"), offset);
    return ProjectBench.units(unitBefore(begin(offset) + number.start())).stream()
        .filter(unit -> UNIT.matcher(unit).matches() && !WORDS.containsKey(unit))
        .map(
            unit ->
                new Completion(
                    unit, ElementKind.ENUMERATION_LITERAL, "", "", unit, false, replaced))
        .toList();
  }

  /** Returns the unit of the name before a number, or else of the field that a bench sends. */
  private String unitBefore(int offset) {
    String before = text.substring(begin(offset), offset);
    if (INTERVAL.matcher(before).find()) {
      return SECOND;
    }
    String unit = "";
    Matcher name = NAMED.matcher(before);
    while (name.find()) {
      String found =
          name.group("topic") != null
              ? project.unit(name.group("topic"), name.group("path"))
              : Optional.ofNullable(WORDS.get(name.group())).map(FormulaWord::unit).orElse("");
      unit = found.isEmpty() ? unit : found;
    }
    YamlText yaml = new YamlText(text);
    return unit.isEmpty() && isBench
        ? yaml.textInLines(offset)
            .or(() -> yaml.place(offset).map(YamlPlace::path))
            .map(path -> ProjectNames.fieldUnit(project, path))
            .orElse("")
        : unit;
  }

  private List<Completion> names(int offset) {
    Matcher begun = BEGUN.matcher(text.substring(begin(offset), offset));
    if (!begun.find() || !isFormula(begin(offset) + begun.start())) {
      return List.of();
    }
    TextRange replaced = lines.range(begin(offset) + begun.start(), offset);
    List<Completion> found = new ArrayList<>();
    WORDS.forEach(
        (name, word) ->
            found.add(
                new Completion(
                    name,
                    word.isOperator() ? ElementKind.KEYWORD : ElementKind.VARIABLE,
                    "",
                    word.about(),
                    name,
                    false,
                    replaced)));
    if (!isBench) {
      fields(begun.group())
          .forEach(
              (name, about) ->
                  found.add(
                      new Completion(
                          name, ElementKind.REFERENCE, "", about, name, false, replaced)));
    }
    return found;
  }

  /** Returns the fields of topics; of many, the next steps of those that begin as a word. */
  private Map<String, String> fields(String begun) {
    Map<String, String> all = project.fields();
    if (all.size() <= MOST) {
      return all;
    }
    String parent = begun.substring(0, begun.lastIndexOf('/') + 1);
    Map<String, String> steps = new LinkedHashMap<>();
    all.forEach(
        (name, about) -> {
          int next = name.indexOf('/', Math.max(1, parent.length()));
          if (name.startsWith(parent)) {
            steps.putIfAbsent(next < 0 ? name : name.substring(0, next + 1), next < 0 ? about : "");
          }
        });
    return steps;
  }

  private static String quoted(String name) {
    return name.contains("'") ? '"' + name + '"' : "'" + name + "'";
  }

  /** Returns what is known of the signal or the word at an offset of a formula. */
  Optional<Hover> described(int offset) {
    return signal(offset)
        .flatMap(this::described)
        .or(() -> named(WORD, offset).flatMap(this::word));
  }

  /** Returns the topic of the signal at an offset. */
  Optional<String> topic(int offset) {
    return signal(offset).map(each -> each.group("topic"));
  }

  private Optional<Matcher> signal(int offset) {
    return named(READ, offset);
  }

  private Optional<Hover> described(Matcher signal) {
    String topic = signal.group("topic");
    String path = signal.group("path");
    List<String> names = project.valueNames(topic, path);
    String about =
        project.fields().getOrDefault(topic + "." + path, "")
            + (names.isEmpty()
                ? ""
                : "\n\nIts values have names: `" + String.join("`, `", names) + "`.");
    return about.isEmpty()
        ? Optional.empty()
        : Optional.of(new Hover(about.strip(), lines.range(signal.start(), signal.end())));
  }

  /** Returns the meaning of an operator or a quantity, behind the key of a formula. */
  private Optional<Hover> word(Matcher word) {
    return Optional.ofNullable(WORDS.get(word.group()))
        .filter(it -> isFormula(word.start()))
        .map(it -> new Hover(it.about(), lines.range(word.start(), word.end())));
  }

  private Optional<Matcher> named(Pattern pattern, int offset) {
    int end = text.indexOf('\n', offset);
    Matcher found = pattern.matcher(text).region(begin(offset), end < 0 ? text.length() : end);
    while (found.find()) {
      if (found.start() <= offset && offset <= found.end()) {
        return Optional.of(found);
      }
    }
    return Optional.empty();
  }

  private int begin(int offset) {
    return offset == 0 ? 0 : text.lastIndexOf('\n', offset - 1) + 1;
  }
}
