package dev.eventchain.m2t.editing;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.editing.SemanticToken;
import dev.eventchain.editing.SemanticToken.Kind;
import dev.eventchain.m2t.syntax.TemplateLexer;
import dev.eventchain.m2t.syntax.Token;
import dev.eventchain.m2t.syntax.Words;
import dev.eventchain.ocl.assist.ExpressionTokens;
import dev.eventchain.ocl.metamodel.PackageIndex;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;
import java.util.TreeMap;

/** The meaning of the words of a template file; text that is copied has none. */
final class TemplateColours {

  private final TemplateText text;
  private final ExpressionTokens tokens;
  private final NavigableMap<Integer, Integer> names = new TreeMap<>();

  private TemplateColours(TemplateText text, List<TemplateUnit> units, PackageIndex packages) {
    this.text = text;
    Set<String> words = new HashSet<>(Words.all());
    this.tokens = new ExpressionTokens(text.lines(), packages, words);
    units.forEach(
        each -> names.put(each.name().start(), each.name().start() + each.name().text().length()));
  }

  static List<SemanticToken> of(
      TemplateText text, List<TemplateUnit> units, PackageIndex packages) {
    TemplateColours colours = new TemplateColours(text, units, packages);
    text.tokens().forEach(colours::add);
    return List.copyOf(colours.tokens.found());
  }

  private void add(Token token) {
    String all = text.written().text();
    switch (token.kind()) {
      case TEXT -> {}
      case COMMENT -> tokens.add(all, token.start(), token.end(), Kind.COMMENT, false);
      default -> {
        int start = token.contentStart();
        String word = token.keyword();
        if (token.kind() == Token.Kind.BROKEN) {
          word = text.wordOf(token);
          start = Math.min(token.end(), token.start() + 1);
          boolean keyword = TemplateLexer.keywords().contains(word);
          word = keyword ? word : "";
          start += word.length();
        }
        if (!word.isEmpty()) {
          SourceRange written = text.wordIn(token);
          tokens.add(all, written.start(), written.end(), Kind.KEYWORD, false);
        }
        addContent(start, token.kind() == Token.Kind.BROKEN ? token.end() : token.contentEnd());
      }
    }
  }

  /** Adds the content of a tag, in which the name of a template or query may be. */
  private void addContent(int start, int end) {
    int from = start;
    for (Map.Entry<Integer, Integer> name : names.subMap(start, end).entrySet()) {
      if (name.getValue() <= end) {
        tokens.addAll(text.written().range(from, name.getKey()));
        tokens.add(text.written().text(), name.getKey(), name.getValue(), Kind.FUNCTION, true);
        from = name.getValue();
      }
    }
    if (from < end) {
      tokens.addAll(text.written().range(from, end));
    }
  }
}
