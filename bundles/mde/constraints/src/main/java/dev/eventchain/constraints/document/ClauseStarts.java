package dev.eventchain.constraints.document;

import dev.eventchain.ocl.text.Keywords;
import dev.eventchain.ocl.text.Tokens;
import java.util.Set;

/** Finds where the clauses of a document begin, whatever stands in them. */
public final class ClauseStarts {

  /** Tokens after which a keyword is a name inside an expression. */
  private static final Set<String> BEFORE_NAMES =
      Set.of(".", "->", "::", "^", ",", "(", "{", "|", "let");

  private ClauseStarts() {}

  /** Returns whether a token begins a clause, rather than being a name in an expression. */
  public static boolean at(Tokens tokens, int index) {
    if (index > 0 && BEFORE_NAMES.contains(tokens.text(index - 1))) {
      return followsUnfinished(tokens, index);
    }
    String token = tokens.text(index);
    boolean named = tokens.isName(index + 1);
    return switch (token) {
      case "endpackage" -> true;
      case "context", "package" -> named;
      case "import", "include", "library" ->
          tokens.isString(index + 1) || isNamedImport(tokens, index);
      case "static" -> tokens.is(index + 1, "def");
      case "inv" -> true;
      case "invariant", "Inv", "INV" -> named && tokens.is(index + 2, ":");
      case "def", "pre", "post", "body", "init", "derive" ->
          tokens.is(index + 1, ":") || (named && tokens.is(index + 2, ":"));
      default -> false;
    };
  }

  /**
   * Returns whether a clause begins although the one before it is not finished: {@code self.}, and
   * then {@code inv Name:} or {@code context Class}. Nowhere else do two names follow each other.
   */
  private static boolean followsUnfinished(Tokens tokens, int index) {
    boolean named = tokens.isName(index + 1) && !Keywords.ALL.contains(tokens.text(index + 1));
    return named
        && (tokens.is(index, "context")
            || (tokens.is(index, "inv")
                && (tokens.is(index + 2, ":") || tokens.is(index + 2, "("))));
  }

  /** Returns whether the import has the form {@code import name : 'uri'} or {@code import a::b}. */
  private static boolean isNamedImport(Tokens tokens, int index) {
    return tokens.isName(index + 1)
        && (tokens.is(index, "import")
            || (tokens.is(index + 2, ":") && tokens.isString(index + 3)));
  }
}
