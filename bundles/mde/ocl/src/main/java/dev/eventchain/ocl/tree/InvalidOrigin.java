package dev.eventchain.ocl.tree;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.metamodel.Names;
import java.util.Collection;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.common.notify.Adapter;
import org.eclipse.emf.common.notify.impl.AdapterImpl;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.ocl.expressions.IfExp;
import org.eclipse.ocl.expressions.InvalidLiteralExp;
import org.eclipse.ocl.expressions.LoopExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.PropertyCallExp;
import org.eclipse.ocl.utilities.CallingASTNode;

/**
 * The innermost expression that was invalid.
 *
 * @param node the expression
 * @param source the value of its source; {@code null} also if unknown
 * @param detail the message of a library or of Java; empty if there is none
 * @param cause its exception; {@code null} if there is none
 */
public record InvalidOrigin(
    OCLExpression<EClassifier> node, Object source, String detail, RuntimeException cause) {

  /** The text of an expression, attached to its root. */
  public static final class Source extends AdapterImpl {
    private final SourceText text;

    /** The reason why the expression replaces another one; empty if it does not. */
    private final String reason;

    public Source(SourceText text) {
      this(text, "");
    }

    public Source(SourceText text, String reason) {
      this.text = text;
      this.reason = reason;
    }

    @Override
    public boolean isAdapterForType(Object type) {
      return type == Source.class;
    }

    SourceText text() {
      return text;
    }
  }

  public Invalid toInvalid() {
    return new Invalid(reason(), locationOf(node), kind(), cause);
  }

  private Invalid.Kind kind() {
    if (node instanceof InvalidLiteralExp<?>) {
      return Invalid.Kind.OTHER;
    } else if (source == null || (node instanceof LoopExp<?, ?> && detail.isEmpty())) {
      return Invalid.Kind.NULL;
    }
    return isEmpty() ? Invalid.Kind.EMPTY : Invalid.Kind.OTHER;
  }

  private boolean isEmpty() {
    return source instanceof Collection<?> collection && collection.isEmpty();
  }

  public static SourceLocation locationOf(OCLExpression<EClassifier> node) {
    return source(node).map(each -> each.text().at(offsetOf(node))).orElse(SourceLocation.NONE);
  }

  /** Returns the text of the expression around a node. */
  static Optional<Source> source(EObject node) {
    for (EObject each = node; each != null; each = each.eContainer()) {
      Adapter source = EcoreUtil.getExistingAdapter(each, Source.class);
      if (source != null) {
        return Optional.of((Source) source);
      }
    }
    return Optional.empty();
  }

  private static final Set<String> DIVISIONS = Set.of("/", "div", "mod");

  /** Returns the offset of the name of a call, rather than of the start of its source. */
  private static int offsetOf(OCLExpression<EClassifier> node) {
    return node instanceof CallingASTNode call
            && call.getPropertyStartPosition() > node.getStartPosition()
        ? call.getPropertyStartPosition()
        : node.getStartPosition();
  }

  private String reason() {
    if (node instanceof OperationCallExp<?, ?> call && call.getReferredOperation() != null) {
      String name = String.valueOf(Names.of(call.getReferredOperation()));
      return operationReason(name);
    } else if (node instanceof PropertyCallExp<?, ?> call) {
      return "'" + Names.of(call.getReferredProperty()) + "' is called on " + described(source);
    } else if (node instanceof LoopExp<?, ?> loop) {
      return source == null
          ? "'" + loop.getName() + "' is applied to null"
          : "the body of '"
              + loop.getName()
              + "' "
              + (detail.isEmpty() ? "is null for an element" : detail);
    } else if (node instanceof IfExp<?> && source == null) {
      return "the condition of an 'if' is null";
    } else if (node instanceof InvalidLiteralExp<?>) {
      String why = source(node).map(each -> each.reason).orElse("");
      return why.isEmpty() ? "'invalid' is written here" : why;
    }
    return detail.isEmpty() ? "it has no value" : detail;
  }

  private String operationReason(String name) {
    if (source == null && detail.isEmpty()) {
      return "'" + name + "' is applied to null";
    }
    if (source == null) {
      return "'" + name + "' has no result" + suffix();
    } else if (source instanceof Number && detail.isEmpty() && DIVISIONS.contains(name)) {
      return "'" + name + "' divides " + source + " by zero or by nothing";
    }
    String subject = isEmpty() ? "an empty collection" : described(source);
    return "'" + name + "' has no result for " + subject + suffix();
  }

  private String suffix() {
    return detail.isEmpty() ? "" : " (" + detail + ")";
  }

  public static String described(Object value) {
    if (value instanceof EObject object) {
      return Names.label(object);
    } else if (value instanceof Collection<?> collection) {
      return "a collection of " + collection.size();
    } else if (value instanceof String text) {
      return "'" + (text.length() > 40 ? text.substring(0, 40) + "..." : text) + "'";
    }
    return String.valueOf(value);
  }
}
