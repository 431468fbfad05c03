package dev.eventchain.ocl.assist;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.editing.SemanticToken;
import dev.eventchain.editing.SemanticToken.Kind;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.ocl.metamodel.PackageIndex;
import dev.eventchain.ocl.text.Keywords;
import dev.eventchain.ocl.text.Lexer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The meaning of words as far as it can be told without types, so that it is found for a whole text
 * after each key: a name after a dot or an arrow is a property or an operation, one that a
 * metamodel has is a type, and others are variables.
 */
public final class ExpressionTokens {

  private final TextLines lines;
  private final PackageIndex packages;
  private final Set<String> words;
  private final Map<String, Boolean> types = new HashMap<>();
  private final List<SemanticToken> found = new ArrayList<>();

  /**
   * Finds tokens.
   *
   * @param words the keywords besides those of OCL
   */
  public ExpressionTokens(TextLines lines, PackageIndex packages, Set<String> words) {
    this.lines = lines;
    this.packages = packages;
    this.words = words;
  }

  /** Returns the tokens so far. */
  public List<SemanticToken> found() {
    return found;
  }

  /** Adds a token, or one for each line of a long one. */
  public void add(String text, int start, int end, Kind kind, boolean declaration) {
    TextPosition position = lines.position(start);
    int from = start;
    while (from < end) {
      int next = from;
      while (next < end && text.charAt(next) != '\n' && text.charAt(next) != '\r') {
        next++;
      }
      if (next > from) {
        position = lines.position(from);
        found.add(
            new SemanticToken(position.line(), position.column(), next - from, kind, declaration));
      }
      from = next + 1;
    }
  }

  /** Adds the tokens of a range. */
  public void addAll(SourceRange range) {
    String text = range.source().text();
    String last = "";
    for (int i = range.start(); i < range.end(); ) {
      int end = Lexer.end(text, i, range.end());
      if (Lexer.isBlank(text, i)) {
        if (!Character.isWhitespace(text.charAt(i))) {
          add(text, i, end, Kind.COMMENT, false);
        }
      } else {
        String word = text.substring(i, end);
        kindOf(text, word, last, end, range.end()).accept(text, i, end, this);
        last = word;
      }
      i = end;
    }
  }

  private record Found(Kind kind) {
    void accept(String text, int start, int end, ExpressionTokens into) {
      if (kind != null) {
        into.add(text, start, end, kind, false);
      }
    }
  }

  private boolean isType(String word) {
    return types.computeIfAbsent(word, each -> !packages.classifiers(List.of(each)).isEmpty());
  }

  private Found kindOf(String text, String word, String last, int end, int limit) {
    char c = word.charAt(0);
    if (c == '\'' || c == '"') {
      return new Found(Kind.STRING);
    } else if (Character.isDigit(c)) {
      return new Found(Kind.NUMBER);
    } else if (!Character.isJavaIdentifierStart(c)) {
      return new Found(null);
    }
    int next = end;
    while (next < limit && Lexer.isBlank(text, next)) {
      next = Lexer.end(text, next, limit);
    }
    boolean called = next < limit && text.charAt(next) == '(';
    if (last.equals(".") || last.equals("->")) {
      return new Found(called ? Kind.OPERATION : Kind.PROPERTY);
    } else if (Keywords.ALL.contains(word) || words.contains(word)) {
      return new Found(Kind.KEYWORD);
    } else if (text.startsWith("::", next) && !isType(word)) {
      return new Found(Kind.NAMESPACE);
    } else if (Keywords.TYPES.contains(word) || isType(word)) {
      return new Found(Kind.TYPE);
    } else if (last.equals("::")) {
      return new Found(called ? Kind.OPERATION : Kind.ENUMERATION_LITERAL);
    }
    return new Found(called ? Kind.OPERATION : Kind.VARIABLE);
  }
}
