package dev.eventchain.ocl;

import java.util.Objects;
import org.eclipse.emf.ecore.EClassifier;

/**
 * The variables that an expression can name, with their static types. Immutable; starts with {@link
 * ExpressionLanguage#root()}.
 */
public final class Scope {

  static final Scope EMPTY = new Scope(null, "", null);

  private final Scope parent;
  private final String name;
  private final EClassifier type;

  private Scope(Scope parent, String name, EClassifier type) {
    this.parent = parent;
    this.name = name;
    this.type = type;
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
    return new Scope(this, Objects.requireNonNull(variable), Objects.requireNonNull(variableType));
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
