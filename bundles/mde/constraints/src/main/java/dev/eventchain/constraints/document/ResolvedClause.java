package dev.eventchain.constraints.document;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.Definitions;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.Scope;
import dev.eventchain.ocl.text.Tokens;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;

/**
 * An invariant or a definition with its resolved names.
 *
 * @param context its class or data type
 * @param contextPackage the package whose types come first
 */
public record ResolvedClause(
    RuleDocument.Clause clause, EClassifier context, EPackage contextPackage) {

  /** Returns the scope with {@code self} and its alias, if there is one. */
  public Scope scope(ExpressionLanguage language) {
    Scope scope = language.root().in(contextPackage).with("self", context);
    String alias = clause.alias();
    return alias.isEmpty() ? scope : scope.withAlias(alias, clause.context().toString());
  }

  public Definitions.Definition definition(ExpressionLanguage language) {
    return new Definitions.Definition(clause.text(), scope(language), clause.location());
  }

  public SourceText source() {
    return clause.text().source();
  }

  public SourceLocation location() {
    return clause.location();
  }

  /** Returns the text without white space and comments. */
  private String words() {
    return new Tokens(clause.text().text()).words();
  }

  /** Returns whether another clause is the same in another document, which is no fault. */
  public boolean repeats(ResolvedClause other) {
    return source() != other.source() && words().equals(other.words());
  }
}
