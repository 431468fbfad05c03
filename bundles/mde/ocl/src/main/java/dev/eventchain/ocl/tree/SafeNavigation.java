package dev.eventchain.ocl.tree;

import org.eclipse.emf.common.notify.impl.AdapterImpl;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.expressions.CallExp;
import org.eclipse.ocl.expressions.OCLExpression;

/**
 * Calls that are written with {@code ?.} or {@code ?->}, of Eclipse's newer dialect: of null they
 * are null, and of a collection they see the elements that are not null (OCL in Eclipse's Pivot
 * implementation, "safe navigation").
 */
public final class SafeNavigation {

  private static final class Mark extends AdapterImpl {}

  private SafeNavigation() {}

  /** Marks an expression, if it is a call. */
  public static void mark(OCLExpression<EClassifier> expression) {
    if (expression instanceof CallExp<?> && !isSafe(expression)) {
      expression.eAdapters().add(new Mark());
    }
  }

  /** Returns whether an expression is a marked call. */
  public static boolean isSafe(OCLExpression<EClassifier> expression) {
    return expression.eAdapters().stream().anyMatch(Mark.class::isInstance);
  }
}
