package dev.eventchain.ocl;

import java.util.Objects;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;

/**
 * The variables that an expression can name, with their static types, and the package whose types
 * come first. Immutable; starts with {@link ExpressionLanguage#root()}.
 */
public final class Scope {

  static final Scope EMPTY = new Scope(null, "", null, null, "");

  private final Scope parent;
  private final String name;
  private final EClassifier type;
  private final EPackage home;
  private final String prefix;

  private Scope(Scope parent, String name, EClassifier type, EPackage home, String prefix) {
    this.parent = parent;
    this.name = name;
    this.type = type;
    this.home = home;
    this.prefix = prefix;
  }

  /**
   * Returns this scope with another variable, which hides any of the same name. The variable {@code
   * self} is the implicit source of calls and navigations.
   *
   * @param variable the name of the variable
   * @param variableType its static type: a class, a data type, or a type of an {@link
   *     ExpressionLanguage}
   */
  public Scope with(String variable, EClassifier variableType) {
    return new Scope(
        this, Objects.requireNonNull(variable), Objects.requireNonNull(variableType), home, prefix);
  }

  /** Returns this scope in a package, in which simple names of types are looked up first. */
  public Scope in(EPackage contextPackage) {
    return new Scope(parent, name, type, contextPackage, prefix);
  }

  /**
   * Returns this scope with an alias of {@code self}.
   *
   * @param alias the alias
   * @param typeName the type of {@code self} as written
   */
  public Scope withAlias(String alias, String typeName) {
    return new Scope(parent, name, type, home, "let " + alias + " : " + typeName + " = self in\n");
  }

  /** Returns the static type of a variable; {@code null} if there is none of this name. */
  public EClassifier typeOf(String variable) {
    for (Scope scope = this; scope.parent != null; scope = scope.parent) {
      if (scope.name.equals(variable)) {
        return scope.type;
      }
    }
    return null;
  }

  /** Returns the package whose types come first; {@code null} for none. */
  EPackage home() {
    return home;
  }

  /** Returns the text to parse before expressions of this scope. */
  String prefix() {
    return prefix;
  }

  Scope parent() {
    return parent;
  }

  String name() {
    return name;
  }

  EClassifier type() {
    return type;
  }
}
