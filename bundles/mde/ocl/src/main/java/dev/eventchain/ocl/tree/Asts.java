package dev.eventchain.ocl.tree;

import org.eclipse.emf.ecore.EAnnotation;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EModelElement;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.ocl.expressions.CollectionItem;
import org.eclipse.ocl.expressions.CollectionLiteralExp;
import org.eclipse.ocl.expressions.CollectionLiteralPart;
import org.eclipse.ocl.expressions.LiteralExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.TupleLiteralExp;
import org.eclipse.ocl.expressions.TypeExp;
import org.eclipse.ocl.expressions.VariableExp;
import org.eclipse.ocl.parser.AbstractOCLAnalyzer;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.utilities.PredefinedType;

/** Kinds of nodes of expressions. */
public final class Asts {

  private Asts() {}

  /** Returns whether a call is a Boolean operation. */
  public static boolean isLogical(OperationCallExp<EClassifier, EOperation> call) {
    return switch (call.getOperationCode()) {
      case PredefinedType.AND,
          PredefinedType.OR,
          PredefinedType.XOR,
          PredefinedType.IMPLIES,
          PredefinedType.NOT ->
          true;
      default -> false;
    };
  }

  /** Returns whether a node is a literal. */
  public static boolean isLiteral(OCLExpression<EClassifier> node) {
    if (node instanceof CollectionLiteralExp<EClassifier> collection) {
      return collection.getPart().stream().allMatch(Asts::isLiteral);
    } else if (node instanceof OperationCallExp<?, ?> call) {
      boolean sign =
          call.getOperationCode() == PredefinedType.MINUS && call.getArgument().isEmpty();
      return sign && call.getSource() instanceof LiteralExp<?>;
    }
    boolean tuple = node instanceof TupleLiteralExp<?, ?>;
    return node instanceof TypeExp<?> || (node instanceof LiteralExp<?> && !tuple);
  }

  private static boolean isLiteral(CollectionLiteralPart<EClassifier> part) {
    return part instanceof CollectionItem<EClassifier> item && isLiteral(item.getItem());
  }

  /** Returns whether a node is {@code self}. */
  public static boolean isSelf(OCLExpression<EClassifier> node) {
    return node instanceof VariableExp<?, ?> use
        && use.getReferredVariable() != null
        && "self".equals(use.getReferredVariable().getName());
  }

  /** Returns the single value in an implicit set before an arrow, or the node itself. */
  public static OCLExpression<EClassifier> withoutImplicitSet(OCLExpression<EClassifier> node) {
    if (node instanceof CollectionLiteralExp<EClassifier> set
        && set.getPart().size() == 1
        && set.getPart().get(0) instanceof CollectionItem<EClassifier> item
        && isImplicit(set)) {
      return item.getItem();
    } else if (node instanceof OperationCallExp<EClassifier, ?> call
        && call.getOperationCode() == PredefinedType.OCL_AS_SET
        && !(call.getSource().getType() instanceof CollectionType<?, ?>)) {
      return call.getSource();
    }
    return node;
  }

  /** Returns whether a set is the implicit one of a single value before an arrow. */
  public static boolean isImplicit(CollectionLiteralExp<EClassifier> literal) {
    EAnnotation annotation =
        literal instanceof EModelElement element
            ? element.getEAnnotation(AbstractOCLAnalyzer.OCL_ANNOTATIONS_URI)
            : null;
    return annotation != null
        && Boolean.parseBoolean(
            annotation.getDetails().get(AbstractOCLAnalyzer.IMPLICIT_SET_CONVERSION));
  }
}
