package dev.eventchain.ocl.editing;

import org.eclipse.emf.ecore.EClassifier;

/**
 * A name in an expression and what it means.
 *
 * @param start the offset of its first character in the source text
 * @param end the offset after its last character
 * @param name the name, without quotes or an underscore that only escapes it
 * @param target the feature, operation, class or literal that it names, or the implementation of a
 *     library's operation; {@code null} for variables and iterators
 * @param type the type of the variable or of the value; {@code null} if unknown
 * @param owner the type before the dot or the arrow; {@code null} if there is none
 * @param declaredAt the offset of the variable's declaration in the source text; {@link
 *     dev.eventchain.ocl.editing.Mention#ELSEWHERE} for one that the expression does not declare
 */
public record Mention(
    int start,
    int end,
    Kind kind,
    String name,
    Object target,
    EClassifier type,
    EClassifier owner,
    int declaredAt) {

  /** Stands for the declaration of a variable outside the expression. */
  public static final int ELSEWHERE = -1;

  /** Meaning of a name. */
  public enum Kind {
    VARIABLE,
    /** The name of a variable where it is declared. */
    DECLARATION,
    FEATURE,
    OPERATION,
    /** An operation with an expression for each element. */
    ITERATOR,
    /** An operation of a library of the dialect. */
    LIBRARY_OPERATION,
    TYPE,
    LITERAL
  }

  /** Returns whether an offset is in the name or at one of its ends. */
  public boolean touches(int offset) {
    return start <= offset && offset <= end;
  }

  /** Returns the same mention of a variable that is declared at an offset. */
  public Mention declaredAt(int offset) {
    return new Mention(start, end, kind, name, target, type, owner, offset);
  }
}
