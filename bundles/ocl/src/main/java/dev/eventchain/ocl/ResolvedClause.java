package dev.eventchain.ocl;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;

/**
 * An invariant or a definition and what its names mean.
 *
 * @param context the class or data type it is about
 * @param contextPackage the package whose types come first
 */
record ResolvedClause(RuleDocument.Clause clause, EClassifier context, EPackage contextPackage) {

  Scope scope() {
    return Scope.EMPTY.with("self", context);
  }

  /** What stands before its expressions, to make another name of {@code self} known. */
  String prefix() {
    String alias = clause.alias();
    return alias.isEmpty() ? "" : "let " + alias + " : " + clause.context() + " = self in\n";
  }

  SourceText source() {
    return clause.text().source();
  }

  SourceLocation location() {
    return clause.location();
  }

  Tokens tokens() {
    return new Tokens(clause.text().text());
  }

  /** The text, whatever its white space and comments. */
  String words() {
    return words(0, tokens().size());
  }

  /** Some of the tokens. */
  String words(int from, int to) {
    Tokens tokens = tokens();
    StringBuilder words = new StringBuilder();
    for (int i = from; i < to; i++) {
      words.append(tokens.text(i)).append(' ');
    }
    return words.toString();
  }

  /** Whether another clause says the same in another document, which is no fault. */
  boolean repeats(ResolvedClause other) {
    return source() != other.source() && words().equals(other.words());
  }
}
