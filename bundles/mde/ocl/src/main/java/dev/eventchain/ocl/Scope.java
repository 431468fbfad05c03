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
   * This scope and one variable more, which hides any of the same name. The variable {@code self}
   * is the source of calls and navigations that have none.
   *
   * @param variable the name of the variable
   * @param variableType its static type: a class, a data type, or a type that an {@link
   *     ExpressionLanguage} gave
   */
  public Scope with(String variable, EClassifier variableType) {
    return new Scope(
        this, Objects.requireNonNull(variable), Objects.requireNonNull(variableType), home, prefix);
  }

  /** This scope in a package: simple names of types are looked for there before anywhere else. */
  public Scope in(EPackage contextPackage) {
    return new Scope(parent, name, type, contextPackage, prefix);
  }

  /**
   * This scope where {@code self} has another name, too.
   *
   * @param alias the other name
   * @param typeName the type of {@code self} as it is written there
   */
  public Scope withAlias(String alias, String typeName) {
    return new Scope(parent, name, type, home, "let " + alias + " : " + typeName + " = self in\n");
  }

  /** The static type of a variable; {@code null} if there is none of this name. */
  public EClassifier typeOf(String variable) {
    for (Scope scope = this; scope.parent != null; scope = scope.parent) {
      if (scope.name.equals(variable)) {
        return scope.type;
      }
    }
    return null;
  }

  /** The package whose types come first; {@code null} for none. */
  EPackage home() {
    return home;
  }

  /** What is before the expressions of this scope. */
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
