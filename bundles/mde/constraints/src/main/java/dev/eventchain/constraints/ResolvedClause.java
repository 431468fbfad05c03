package dev.eventchain.constraints;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.Definitions;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.Scope;
import dev.eventchain.ocl.text.Tokens;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;

/**
 * An invariant or a definition and what its names mean.
 *
 * @param context the class or data type it is about
 * @param contextPackage the package whose types come first
 */
record ResolvedClause(RuleDocument.Clause clause, EClassifier context, EPackage contextPackage) {

  /** In an empty one of the language: {@code self}, and its other name if there is one. */
  Scope scope(ExpressionLanguage language) {
    Scope scope = language.root().in(contextPackage).with("self", context);
    String alias = clause.alias();
    return alias.isEmpty() ? scope : scope.withAlias(alias, clause.context().toString());
  }

  Definitions.Definition definition(ExpressionLanguage language) {
    return new Definitions.Definition(clause.text(), scope(language), clause.location());
  }

  SourceText source() {
    return clause.text().source();
  }

  SourceLocation location() {
    return clause.location();
  }

  /** The text, whatever its white space and comments. */
  private String words() {
    return new Tokens(clause.text().text()).words();
  }

  /** Whether another clause says the same in another document, which is not a fault. */
  boolean repeats(ResolvedClause other) {
    return source() != other.source() && words().equals(other.words());
  }
}
