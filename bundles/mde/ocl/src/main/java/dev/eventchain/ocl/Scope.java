package dev.eventchain.ocl;

import java.util.LinkedHashSet;
import java.util.Objects;
import java.util.Set;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;

/**
 * The variables that an expression can name, with their static types, and the package whose types
 * come first. Immutable; starts with {@link ExpressionLanguage#root()}.
 */
public final class Scope {

  /** Stands for the offset of a variable that is declared in no text. */
  public static final int UNKNOWN = -1;

  static final Scope EMPTY = new Scope(null, "", null, null, "", UNKNOWN);

  private final Scope parent;
  private final String name;
  private final EClassifier type;
  private final EPackage home;
  private final String prefix;
  private final int offset;

  private Scope(
      Scope parent, String name, EClassifier type, EPackage home, String prefix, int offset) {
    this.parent = parent;
    this.name = name;
    this.type = type;
    this.home = home;
    this.prefix = prefix;
    this.offset = offset;
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
    return with(variable, variableType, UNKNOWN);
  }

  /**
   * As {@link #with(String, EClassifier)}, with the place of the declaration, for editors.
   *
   * @param declaredAt the offset of its name in the text of the expressions
   */
  public Scope with(String variable, EClassifier variableType, int declaredAt) {
    return new Scope(
        this,
        Objects.requireNonNull(variable),
        Objects.requireNonNull(variableType),
        home,
        prefix,
        declaredAt);
  }

  /** Returns this scope in a package, in which simple names of types are looked up first. */
  public Scope in(EPackage contextPackage) {
    return new Scope(parent, name, type, contextPackage, prefix, offset);
  }

  /**
   * Returns this scope with an alias of {@code self}.
   *
   * @param alias the alias
   * @param typeName the type of {@code self} as written
   */
  public Scope withAlias(String alias, String typeName) {
    String let = "let " + alias + " : " + typeName + " = self in\n";
    return new Scope(parent, name, type, home, let, offset);
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

  /** Returns the offset at which a variable is declared; {@link #UNKNOWN} if it is not known. */
  public int offsetOf(String variable) {
    for (Scope scope = this; scope.parent != null; scope = scope.parent) {
      if (scope.name.equals(variable)) {
        return scope.offset;
      }
    }
    return UNKNOWN;
  }

  /** Returns the names of the variables, the innermost first. */
  public Set<String> names() {
    Set<String> names = new LinkedHashSet<>();
    for (Scope scope = this; scope.parent != null; scope = scope.parent) {
      names.add(scope.name);
    }
    return names;
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
