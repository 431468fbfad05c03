package dev.eventchain.m2t.editing;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.syntax.TagBlock;
import dev.eventchain.m2t.syntax.Token;
import dev.eventchain.m2t.syntax.Words;
import dev.eventchain.ocl.ExpressionSyntax;
import dev.eventchain.ocl.text.Spacing;
import dev.eventchain.ocl.text.Symbol;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Formatter of templates, which changes nothing that they generate: spaces between the symbols
 * inside a tag, and those at the ends of lines between the blocks of a module. Lines, the
 * indentation of what goes on inside a tag, comments and all text that is copied stay.
 */
public final class TemplateFormatter {

  private static final Set<String> WORDS = Set.copyOf(Words.all());

  private final SourceText source;
  private final ExpressionSyntax syntax = new ExpressionSyntax();
  private final StringBuilder result = new StringBuilder();

  private TemplateFormatter(SourceText source) {
    this.source = source;
  }

  /** Formats a template; empty if the tags of the text have an error, and it is left as it is. */
  public static Optional<String> format(String text) {
    SourceText source = SourceText.of("", text);
    List<Diagnostic> problems = new ArrayList<>();
    List<Token> tokens = TagBlock.tokens(source, problems);
    if (!problems.isEmpty()) {
      return Optional.empty();
    }
    String formatted = new TemplateFormatter(source).run(tokens);
    SourceText after = SourceText.of("", formatted);
    return described(source, tokens).equals(described(after, TagBlock.tokens(after, problems)))
        ? Optional.of(formatted)
        : Optional.empty();
  }

  /** Returns the first error of the tags of a text, which is why it is not formatted. */
  public static Optional<Diagnostic> syntaxError(SourceText source) {
    List<Diagnostic> problems = new ArrayList<>();
    TagBlock.tokens(source, problems);
    return problems.stream().filter(each -> each.severity() == Severity.ERROR).findFirst();
  }

  private String run(List<Token> tokens) {
    int depth = 0;
    for (Token token : tokens) {
      depth -= token.kind() == Token.Kind.CLOSE ? 1 : 0;
      String written = source.text().substring(token.start(), token.end());
      result.append(
          switch (token.kind()) {
            case TEXT -> depth == 0 ? withoutEnds(written) : written;
            case COMMENT, BROKEN -> written;
            case CLOSE -> written.isEmpty() ? "" : "[/" + token.keyword() + "]";
            default -> tag(token, written);
          });
      depth += token.kind() == Token.Kind.OPEN ? 1 : 0;
    }
    return result.toString();
  }

  private static String withoutEnds(String text) {
    return text.replaceAll("[ \\t]+(?=[\\r\\n])", "");
  }

  private String tag(Token tag, String written) {
    boolean isExpression = tag.kind() == Token.Kind.EXPRESSION;
    boolean isCondition = tag.keyword().endsWith("if");
    String content = source.text().substring(tag.contentStart(), tag.contentEnd());
    List<Symbol> symbols = Symbol.in(content);
    boolean isSound =
        !(isExpression || isCondition)
            || symbols.stream().anyMatch(each -> WORDS.contains(each.text()))
            || syntax.isExpression(source.range(tag.contentStart(), tag.contentEnd()));
    if (!isSound || symbols.size() == 1 || !isBalanced(symbols)) {
      return written;
    }
    Spacing spacing = new Spacing(symbols, Set.of(), WORDS);
    StringBuilder line = new StringBuilder("[").append(tag.keyword());
    for (int i = 0; i < symbols.size() - 1; i++) {
      Symbol symbol = symbols.get(i);
      boolean isNext = i > 0 && !isAfterBreak(symbol);
      String first = isExpression ? "" : " ";
      line.append(
          isNext ? spacing.before(symbol, i) : isAfterBreak(symbol) ? lines(symbol.gap()) : first);
      line.append(symbol.text());
    }
    Symbol end = symbols.get(symbols.size() - 1);
    boolean isClosed = source.text().charAt(tag.contentEnd()) == '/';
    String space = isClosed && !end.gap().isEmpty() ? " " : "";
    line.append(isAfterBreak(end) ? lines(end.gap()) : space);
    return line.append(isClosed ? "/]" : "]").toString();
  }

  private static boolean isAfterBreak(Symbol symbol) {
    return symbol.gap().indexOf('\n') >= 0 || symbol.gap().indexOf('\r') >= 0;
  }

  /** Returns line breaks and the indentation after them, without spaces at the ends of lines. */
  private static String lines(String gap) {
    return withoutEnds(gap);
  }

  private static boolean isBalanced(List<Symbol> symbols) {
    int depth = 0;
    for (Symbol each : symbols) {
      depth += each.is("(") || each.is("{") ? 1 : each.is(")") || each.is("}") ? -1 : 0;
      if (depth < 0) {
        return false;
      }
    }
    return depth == 0;
  }

  /** Returns what tokens say, without the white space inside of tags. */
  private static List<String> described(SourceText source, List<Token> tokens) {
    List<String> all = new ArrayList<>();
    int depth = 0;
    for (Token token : tokens) {
      depth -= token.kind() == Token.Kind.CLOSE ? 1 : 0;
      String written = source.text().substring(token.start(), token.end());
      String content = source.text().substring(token.contentStart(), token.contentEnd());
      all.add(
          switch (token.kind()) {
            case TEXT -> depth == 0 ? withoutEnds(written) : written;
            case COMMENT, BROKEN -> written;
            default ->
                token.kind()
                    + token.keyword()
                    + Symbol.in(content).stream().map(s -> s.kind() + s.text()).toList()
                    + written.lines().count();
          });
      depth += token.kind() == Token.Kind.OPEN ? 1 : 0;
    }
    return all;
  }
}
