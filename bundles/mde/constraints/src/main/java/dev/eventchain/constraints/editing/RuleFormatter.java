package dev.eventchain.constraints.editing;

import dev.eventchain.constraints.document.RuleDocument;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.ExpressionSyntax;
import dev.eventchain.ocl.text.Spacing;
import dev.eventchain.ocl.text.Symbol;
import dev.eventchain.ocl.text.Tokens;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Formatter of Complete OCL documents. Changes white space inside lines only: what stands on a line
 * stays on it, and comments and blank lines stay where they are, since a blank line divides the
 * comment of a constraint from others. Its result has the same symbols, so it means the same.
 */
public final class RuleFormatter {

  private final List<Symbol> symbols;
  private final Spacing spacing;
  private final Indentation indentation;
  private final String step;
  private final String lineBreak;
  private final StringBuilder result = new StringBuilder();

  private RuleFormatter(String text, String step) {
    this.symbols = Symbol.in(text);
    Headings headings = Headings.in(new Tokens(text));
    this.spacing = new Spacing(symbols, headings.colons(), Set.of());
    this.indentation = new Indentation(symbols, headings);
    this.step = step;
    this.lineBreak = text.contains("\r\n") ? "\r\n" : "\n";
  }

  /**
   * Formats a document.
   *
   * @param step the white space of one level of indentation
   * @return empty if the text has a syntax error, and is better left as it is
   */
  public static Optional<String> format(String text, String step) {
    return problems(SourceText.of("", text)).findFirst().isEmpty()
        ? new RuleFormatter(text, step).run()
        : Optional.empty();
  }

  /** Returns the first syntax error of a document, which is why it is not formatted. */
  public static Optional<Diagnostic> syntaxError(SourceText source) {
    return problems(source).filter(each -> each.severity() == Severity.ERROR).findFirst();
  }

  private static Stream<Diagnostic> problems(SourceText source) {
    List<Diagnostic> problems = new ArrayList<>();
    RuleDocument document = RuleDocument.read(source, problems);
    ExpressionSyntax syntax = new ExpressionSyntax();
    Stream<Diagnostic> ofClauses =
        document.clauses().stream()
            .flatMap(
                each ->
                    (each.definition()
                            ? syntax.errorOfDefinition(each.text())
                            : syntax.errorOfExpression(each.text()))
                        .stream());
    Stream<Diagnostic> ofMembers =
        document.members().stream().flatMap(each -> syntax.errorOfExpression(each.text()).stream());
    return Stream.concat(problems.stream(), Stream.concat(ofClauses, ofMembers));
  }

  private Optional<String> run() {
    for (int i = 0; i < symbols.size() - 1; i++) {
      Symbol symbol = symbols.get(i);
      String indent = symbol.isFirstOfLine() ? step.repeat(indentation.level(i)) : "";
      result.append(
          symbol.isFirstOfLine() ? lines(symbol.gap(), indent) : spacing.before(symbol, i));
      result.append(symbol.text());
      if (!indentation.accept(i)) {
        return Optional.empty();
      }
    }
    if (symbols.size() > 1) {
      result.append(firstBreak(symbols.get(symbols.size() - 1).gap()));
    }
    String formatted = result.toString();
    return isSame(Symbol.in(formatted)) ? Optional.of(formatted) : Optional.empty();
  }

  /** Returns the line breaks of white space before a line, and its new indentation. */
  private static String lines(String gap, String indent) {
    boolean usual = gap.chars().allMatch(c -> " \t\r\n".indexOf(c) >= 0);
    return usual ? gap.replaceAll("[ \t]", "") + indent : gap;
  }

  /** Returns the end of the last line, without the blank lines below it. */
  private String firstBreak(String gap) {
    String breaks = gap.replaceAll("[^\r\n]", "");
    return breaks.isEmpty()
        ? lineBreak
        : breaks.startsWith("\r\n") ? "\r\n" : breaks.substring(0, 1);
  }

  private boolean isSame(List<Symbol> others) {
    boolean same = others.size() == symbols.size();
    for (int i = 0; same && i < others.size() - 1; i++) {
      Symbol before = symbols.get(i);
      Symbol after = others.get(i);
      same =
          before.kind() == after.kind()
              && before.text().equals(after.text())
              && before.isFirstOfLine() == after.isFirstOfLine();
    }
    return same;
  }
}
