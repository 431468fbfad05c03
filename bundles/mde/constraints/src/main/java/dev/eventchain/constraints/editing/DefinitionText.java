package dev.eventchain.constraints.editing;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.ocl.text.Tokens;
import java.util.ArrayList;
import java.util.List;

/**
 * The parts of a definition: {@code def: name(parameter : Type) : Type = value}.
 *
 * @param operation whether there are parentheses after the name, be they empty
 * @param result the result's type; empty if it is missing
 * @param value the value, up to the end; empty if it is missing
 */
record DefinitionText(
    String name,
    int nameStart,
    boolean operation,
    List<Parameter> parameters,
    SourceRange result,
    SourceRange value) {

  /** A parameter, and the text of its type. */
  record Parameter(String name, int start, SourceRange type) {}

  /** Reads a definition, which need not be complete. */
  static DefinitionText of(SourceRange text) {
    Tokens tokens = new Tokens(text.text());
    int colon = 0;
    while (colon < tokens.size() && !tokens.is(colon, ":")) {
      colon++;
    }
    int name = Math.min(colon + 1, tokens.size());
    List<Parameter> parameters = new ArrayList<>();
    int at = name + 1;
    boolean operation = tokens.is(at, "(");
    if (operation) {
      at = readParameters(tokens, at + 1, text, parameters);
    }
    int equals = at;
    while (equals < tokens.size() && !tokens.is(equals, "=")) {
      equals++;
    }
    boolean named = name < tokens.size() && tokens.isName(name);
    int start = text.start();
    return new DefinitionText(
        named ? tokens.text(name) : "",
        named ? start + tokens.start(name) : start,
        operation,
        parameters,
        tokens.is(at, ":") ? range(text, tokens, at + 1, equals) : empty(text),
        equals < tokens.size()
            ? text.source().range(start + tokens.end(equals), text.end())
            : empty(text));
  }

  /** Returns the index after the parameters. */
  private static int readParameters(
      Tokens tokens, int from, SourceRange text, List<Parameter> parameters) {
    int at = from;
    while (at < tokens.size() && !tokens.is(at, ")") && !tokens.is(at, "=")) {
      int end = at;
      int depth = 0;
      while (end < tokens.size()
          && (depth > 0 || !(tokens.is(end, ",") || tokens.is(end, ")") || tokens.is(end, "=")))) {
        depth += tokens.is(end, "(") ? 1 : tokens.is(end, ")") ? -1 : 0;
        end++;
      }
      if (tokens.isName(at) && tokens.is(at + 1, ":")) {
        int start = text.start() + tokens.start(at);
        parameters.add(new Parameter(tokens.text(at), start, range(text, tokens, at + 2, end)));
      }
      at = tokens.is(end, ",") ? end + 1 : end;
    }
    return tokens.is(at, ")") ? at + 1 : at;
  }

  private static SourceRange range(SourceRange text, Tokens tokens, int from, int to) {
    return from >= to
        ? empty(text)
        : text.source().range(text.start() + tokens.start(from), text.start() + tokens.end(to - 1));
  }

  private static SourceRange empty(SourceRange text) {
    return text.source().range(text.end(), text.end());
  }

  /** Returns whether there is an equals sign, after which the value can be written. */
  boolean hasValue() {
    return value.start() > 0 && value.source().text().charAt(value.start() - 1) == '=';
  }

  /** Returns {@code name(parameter : Type) : Type}, on one line. */
  String signature() {
    return head() + (result.isEmpty() ? "" : " : " + line(result));
  }

  /** Returns {@code name(parameter : Type)}, on one line. */
  String head() {
    List<String> all =
        parameters.stream().map(each -> each.name() + " : " + line(each.type())).toList();
    return operation ? name + "(" + String.join(", ", all) + ")" : name;
  }

  private static String line(SourceRange range) {
    return range.text().replaceAll("\\s+", " ");
  }
}
