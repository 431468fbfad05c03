package dev.eventchain.constraints.editing;

import dev.eventchain.constraints.document.ClauseStarts;
import dev.eventchain.ocl.text.Tokens;
import java.util.HashSet;
import java.util.Set;

/**
 * Clauses by the offsets of their first words.
 *
 * @param outer the offsets of words that begin a context, a package or an import
 * @param members the offsets of words that begin an invariant or a definition
 * @param colons the offsets of colons that end the heading of one
 * @param bodies the offsets of the equals signs of definitions
 */
record Headings(
    Set<Integer> outer, Set<Integer> members, Set<Integer> colons, Set<Integer> bodies) {

  private static final Set<String> OUTER =
      Set.of("context", "package", "endpackage", "import", "include", "library");

  static Headings in(Tokens tokens) {
    Headings found =
        new Headings(new HashSet<>(), new HashSet<>(), new HashSet<>(), new HashSet<>());
    for (int i = 0; i < tokens.size(); i++) {
      if (ClauseStarts.at(tokens, i)) {
        found.add(tokens, i);
      }
    }
    return found;
  }

  private void add(Tokens tokens, int first) {
    if (OUTER.contains(tokens.text(first))) {
      outer.add(tokens.start(first));
    } else if (first == 0 || !tokens.is(first - 1, "static")) {
      members.add(tokens.start(first));
      addHeading(tokens, tokens.is(first, "static") ? first + 1 : first);
    }
  }

  private void addHeading(Tokens tokens, int keyword) {
    int at = keyword + (tokens.isName(keyword + 1) ? 2 : 1);
    at = tokens.is(at, "(") ? tokens.closing(at) + 1 : at;
    if (!tokens.is(at, ":")) {
      return;
    }
    colons.add(tokens.start(at));
    int equals = at + 1;
    for (int depth = 0; tokens.is(keyword, "def") && equals < tokens.size(); equals++) {
      depth += tokens.is(equals, "(") ? 1 : tokens.is(equals, ")") ? -1 : 0;
      if (depth == 0 && tokens.is(equals, "=")) {
        bodies.add(tokens.start(equals));
        return;
      }
    }
  }
}
