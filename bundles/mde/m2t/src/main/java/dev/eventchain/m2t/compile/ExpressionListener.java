package dev.eventchain.m2t.compile;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.ocl.Scope;
import org.eclipse.emf.ecore.EClassifier;

/** Listener to the expressions of a template as they are compiled, in the scope of each. */
public interface ExpressionListener {

  /** Hears nothing. */
  ExpressionListener NONE = new ExpressionListener() {};

  /** Takes an expression, valid or not. */
  default void expression(SourceRange span, Scope scope) {}

  /** Takes the text of a type. */
  default void type(SourceRange span) {}

  /** Takes a variable and its type. */
  default void variable(Syntax.Variable variable, EClassifier type) {}

  /**
   * Takes the scope of a block's body.
   *
   * @param start the offset of the tag before the body
   */
  default void body(int start, Scope scope) {}
}
