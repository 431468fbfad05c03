package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.m2t.syntax.Syntax.Decoration;
import dev.eventchain.m2t.syntax.Syntax.Name;
import dev.eventchain.m2t.syntax.Syntax.Variable;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Reader of the content of one tag from left to right. */
final class HeaderReader {
  private static final Set<String> LITERALS =
      Set.of("Set", "OrderedSet", "Bag", "Sequence", "Collection", "Tuple");

  private final String text;
  private final Problems problems;
  private final int limit;
  private int position;

  HeaderReader(Problems problems, SourceRange inside) {
    this.text = problems.source().text();
    this.problems = problems;
    this.position = inside.start();
    this.limit = inside.end();
  }

  int position() {
    skipSpace();
    return position;
  }

  boolean atEnd() {
    skipSpace();
    return position >= limit;
  }

  boolean at(char c) {
    skipSpace();
    return position < limit && text.charAt(position) == c;
  }

  boolean accept(char c) {
    if (!at(c)) {
      return false;
    }
    position++;
    return true;
  }

  boolean atWord(String word) {
    skipSpace();
    int end = position + word.length();
    return end <= limit
        && text.startsWith(word, position)
        && (end == limit || !Character.isJavaIdentifierPart(text.charAt(end)));
  }

  /** Reads over a character as often as it comes. */
  void skip(char c) {
    boolean more = accept(c);
    while (more) {
      more = accept(c);
    }
  }

  boolean acceptWord(String word) {
    if (!atWord(word)) {
      return false;
    }
    position += word.length();
    return true;
  }

  /** Reads an identifier; empty if there is none. */
  Optional<Name> name() {
    skipSpace();
    int start = position;
    while (position < limit && Character.isJavaIdentifierPart(text.charAt(position))) {
      position++;
    }
    return position == start
        ? Optional.empty()
        : Optional.of(new Name(text.substring(start, position), start));
  }

  /** Reads a qualified name {@code a::b::c}; empty if there is none. */
  Optional<Name> qualifiedName() {
    Optional<Name> first = name();
    if (first.isEmpty()) {
      return first;
    }
    StringBuilder whole = new StringBuilder(first.get().text());
    while (text.startsWith("::", position) && position + 2 < limit) {
      position += 2;
      name().ifPresent(part -> whole.append("::").append(part.text()));
    }
    return Optional.of(new Name(whole.toString(), first.get().start()));
  }

  /** Reads {@code (...)} and returns the content of the parentheses; reports missing ones. */
  Optional<SourceRange> parentheses(String what) {
    if (!at('(')) {
      problems.syntax(position, "Expected " + what + " in parentheses.", "");
      return Optional.empty();
    }
    int close = closing(position);
    if (close < 0) {
      problems.syntax(position, "This parenthesis is not closed inside its tag.", "");
      position = limit;
      return Optional.empty();
    }
    SourceRange inside = problems.source().range(position + 1, close);
    position = close + 1;
    return Optional.of(inside);
  }

  /** Reads a condition up to variables in braces or the end, without enclosing parentheses. */
  Optional<SourceRange> condition() {
    int start = position();
    SourceRange whole = until("{");
    int end = position;
    if (whole.isEmpty()) {
      unexpected("a condition in parentheses");
      return Optional.empty();
    }
    position = start;
    Optional<SourceRange> inside = at('(') ? parentheses("a condition") : Optional.empty();
    boolean around = inside.isPresent() && position() >= whole.end();
    position = end;
    return around || (inside.isEmpty() && text.charAt(start) == '(') ? inside : Optional.of(whole);
  }

  /** Reads up to one of some characters outside parentheses and quotes, or to the end. */
  SourceRange until(String stops) {
    skipSpace();
    int start = position;
    while (position < limit) {
      char c = text.charAt(position);
      if (stops.indexOf(c) >= 0 && !(c == '{' && opensLiteral(start))) {
        break;
      }
      int close = c == '(' || c == '{' ? closing(position) : -1;
      if (c == '\'') {
        close = Quotes.close(text, position, limit);
      }
      position = close < 0 ? position + 1 : close + 1;
    }
    position = Math.min(position, limit);
    return problems.source().range(start, position).strip();
  }

  /** Returns whether the brace at the position belongs to a literal such as {@code Sequence{1}}. */
  private boolean opensLiteral(int start) {
    int end = position;
    while (end > start && Character.isWhitespace(text.charAt(end - 1))) {
      end--;
    }
    int word = end;
    while (word > start && Character.isJavaIdentifierPart(text.charAt(word - 1))) {
      word--;
    }
    return LITERALS.contains(text.substring(word, end));
  }

  SourceRange rest() {
    return until("");
  }

  /** Reads {@code separator(...) before(...) after(...) ? (...) {...}} in any order. */
  Decoration decoration() {
    Optional<SourceRange> before = Optional.empty();
    Optional<SourceRange> separator = Optional.empty();
    Optional<SourceRange> after = Optional.empty();
    Optional<SourceRange> guard = Optional.empty();
    List<Variable> variables = List.of();
    while (!atEnd()) {
      if (acceptWord(Words.BEFORE)) {
        before = parentheses("the text before the first item");
      } else if (acceptWord(Words.SEPARATOR)) {
        separator = parentheses("the text between items");
      } else if (acceptWord(Words.AFTER)) {
        after = parentheses("the text after the last item");
      } else if (accept('?')) {
        guard = parentheses("a condition");
      } else if (at('{')) {
        variables = variablesInBraces();
      } else {
        unexpected("before(), separator(), after(), ?(), {...} or the end of the tag");
        break;
      }
    }
    return new Decoration(before, separator, after, guard, variables);
  }

  /** Reads {@code {name : type = value; name : type; ...}}; empty without braces. */
  List<Variable> variablesInBraces() {
    List<Variable> variables = new ArrayList<>();
    if (!at('{')) {
      return variables;
    }
    int close = closing(position);
    if (close < 0) {
      problems.syntax(position, "This brace is not closed inside its tag.", "");
      position = limit;
      return variables;
    }
    HeaderReader inside = new HeaderReader(problems, problems.source().range(position + 1, close));
    while (!inside.atEnd()) {
      inside.variableInBraces().ifPresent(variables::add);
      if (!inside.accept(';')) {
        break;
      }
    }
    inside.expectEnd("';' or the end of the variables");
    position = close + 1;
    return variables;
  }

  /** Reads {@code name : type = value} or {@code name : type}, up to a semicolon or the end. */
  private Optional<Variable> variableInBraces() {
    Optional<Variable> declared = variable("={;");
    boolean typed = declared.isPresent() && declared.get().type().isPresent();
    return typed && (at(';') || atEnd()) ? declared : withValue(declared);
  }

  /** Reads {@code name : type = value}, up to a semicolon or the end. */
  Optional<Variable> variableWithValue() {
    return withValue(variable("={;"));
  }

  private Optional<Variable> withValue(Optional<Variable> declared) {
    if (declared.isEmpty()) {
      return declared;
    }
    if (!accept('=')) {
      unexpected("'=' and a value");
      position = limit;
      return Optional.empty();
    }
    SourceRange value = until(";{");
    return Optional.of(
        new Variable(declared.get().name(), declared.get().type(), Optional.of(value)));
  }

  /** Reads {@code name : type} or {@code name}. */
  Optional<Variable> variable(String stops) {
    Optional<Name> name = name();
    if (name.isEmpty()) {
      unexpected("the name of a variable");
      position = limit;
      return Optional.empty();
    }
    Optional<SourceRange> type = Optional.empty();
    if (accept(':')) {
      type = Optional.of(until(stops));
      if (type.get().isEmpty()) {
        problems.syntax(position, "Expected a type.", "");
        position = limit;
        return Optional.empty();
      }
    }
    return Optional.of(new Variable(name.get(), type, Optional.empty()));
  }

  /** Reads {@code (name : type, ...)}. */
  List<Variable> parameters() {
    Optional<SourceRange> inside = parentheses("the parameters");
    List<Variable> parameters = new ArrayList<>();
    if (inside.isEmpty()) {
      return parameters;
    }
    HeaderReader reader = new HeaderReader(problems, inside.get());
    while (!reader.atEnd()) {
      Optional<Variable> parameter = reader.variable(",");
      if (parameter.isPresent() && parameter.get().type().isEmpty()) {
        problems.syntax(parameter.get().name().start(), "A parameter needs a type.", "");
      } else {
        parameter.ifPresent(parameters::add);
      }
      if (!reader.accept(',')) {
        break;
      }
    }
    reader.expectEnd("',' or the end of the parameters");
    return parameters;
  }

  void expectEnd(String expected) {
    if (!atEnd()) {
      unexpected(expected);
    }
  }

  void unexpected(String expected) {
    skipSpace();
    int end = position;
    while (end < limit && Character.isJavaIdentifierPart(text.charAt(end))) {
      end++;
    }
    end = Math.min(limit, Math.max(end, position + 1));
    String found = position >= limit ? "the end" : "'" + text.substring(position, end) + "'";
    problems.syntax(position, "Expected " + expected + ", not " + found + ".", "");
  }

  private int closing(int open) {
    char opener = text.charAt(open);
    char closer = opener == '(' ? ')' : '}';
    int depth = 0;
    for (int i = open; i < limit; i++) {
      char c = text.charAt(i);
      if (c == '\'') {
        int close = Quotes.close(text, i, limit);
        i = close < 0 ? limit : close;
      } else if (c == opener) {
        depth++;
      } else if (c == closer && --depth == 0) {
        return i;
      }
    }
    return -1;
  }

  private void skipSpace() {
    while (position < limit && Character.isWhitespace(text.charAt(position))) {
      position++;
    }
  }
}
