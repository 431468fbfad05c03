package dev.eventchain.ocl;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.explain.Explanation;
import dev.eventchain.ocl.explain.SubExpressions;
import dev.eventchain.ocl.metamodel.OclAnnotations;
import dev.eventchain.ocl.nodes.Frame;
import dev.eventchain.ocl.nodes.Lowered;
import dev.eventchain.ocl.nodes.Run;
import dev.eventchain.ocl.parse.Libraries;
import dev.eventchain.ocl.tree.InvalidOrigin;
import dev.eventchain.ocl.values.Halted;
import dev.eventchain.ocl.values.Values;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.ENamedElement;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.ocl.expressions.CollectionItem;
import org.eclipse.ocl.expressions.CollectionLiteralExp;
import org.eclipse.ocl.expressions.IteratorExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.PropertyCallExp;
import org.eclipse.ocl.expressions.TypeExp;
import org.eclipse.ocl.expressions.VariableExp;
import org.eclipse.ocl.types.CollectionType;

/**
 * A parsed and checked OCL expression. Immutable; several threads can evaluate it at the same time,
 * each with an {@link Evaluation} of its own.
 */
public final class Expression {

  /** Operations that give no more elements than their source has, and one for a single value. */
  private static final Set<String> KEEPING =
      Set.of("oclAsSet", "asSet", "asBag", "select", "reject");

  private final ExpressionLanguage language;
  private final OCLExpression<EClassifier> ast;

  /** Created at the first evaluation; volatile, as not all of its fields are final. */
  private volatile Lowered lowered;

  /** As {@link #lowered}, to explain invalid values; created when first needed. */
  private volatile Lowered traced;

  /** Created when first needed, like the next field; concurrent threads get equal results. */
  private volatile SourceLocation location;

  private volatile Parts parts;

  /** Evaluated by explanations; created when first needed. */
  private volatile SubExpressions subExpressions;

  Expression(ExpressionLanguage language, OCLExpression<EClassifier> ast) {
    this.language = language;
    this.ast = ast;
  }

  /** Returns the static type of the value. */
  public EClassifier type() {
    return ast.getType();
  }

  /** Returns the location of the expression. */
  public SourceLocation location() {
    SourceLocation known = location;
    if (known == null) {
      known = InvalidOrigin.locationOf(ast);
      location = known;
    }
    return known;
  }

  /**
   * Returns the implementation of the outermost call, if it calls a library: for {@code x.f()} that
   * of {@code f}, also if it is called for each element of a collection.
   *
   * @return empty if the outermost node is no call of a library operation
   */
  public Optional<OperationLibrary.Implementation> outermostCall() {
    OCLExpression<?> outermost = ast;
    if (ast instanceof IteratorExp<?, ?> loop && loop.getName().equals("collect")) {
      outermost = loop.getBody();
    }
    return outermost instanceof OperationCallExp<?, ?> call
            && call.getReferredOperation() instanceof Libraries.LibraryOperation operation
        ? Optional.of(operation.implementation())
        : Optional.empty();
  }

  /**
   * A call of a library operation.
   *
   * @param sourceType the static type of the source; arbitrary if there is none
   * @param implementation its implementation in the library
   */
  public record LibraryCall(
      EClassifier sourceType, OperationLibrary.Implementation implementation) {}

  /**
   * A feature that an expression reads.
   *
   * @param type the static class of the object
   */
  public record Navigation(EClass type, EStructuralFeature feature) {}

  /** Returns the features it reads, also through definitions, in the order of first mention. */
  public List<Navigation> navigations() {
    return Navigations.of(ast, language.environment());
  }

  /**
   * Returns whether the effect of a part may depend on other parts or on the content of a
   * collection. So it is if the expression, or a definition that it uses, has a connective of
   * Booleans, an {@code if} or a loop.
   */
  public boolean isConditional() {
    return Navigations.isConditional(ast, language.environment());
  }

  /**
   * Returns the texts and numbers that stand in it and in the definitions that it uses, in the
   * order of first mention: with these it compares what it reads.
   */
  public Set<Object> literals() {
    return Navigations.literals(ast, language.environment());
  }

  /** Returns the calls of library operations anywhere in the expression. */
  public List<LibraryCall> libraryCalls() {
    return parts().calls();
  }

  /**
   * Returns the names of all variables that the expression reads, including those that it declares
   * and an implicit {@code self}.
   */
  public Set<String> variableNames() {
    return parts().variables();
  }

  /**
   * Returns whether the value is known statically to be a collection of at most one element, such
   * as {@code x->filter(T)} for a single x. Its order has no meaning.
   */
  public boolean holdsAtMostOne() {
    return holdsAtMostOne(ast);
  }

  private static boolean holdsAtMostOne(OCLExpression<?> expression) {
    if (expression instanceof CollectionLiteralExp<?> literal) {
      return literal.getPart().size() <= 1
          && literal.getPart().stream().allMatch(CollectionItem.class::isInstance);
    }
    if (expression instanceof OperationCallExp<?, ?> call && isSelection(call)) {
      boolean single = !(call.getSource().getType() instanceof CollectionType);
      return single || holdsAtMostOne(call.getSource());
    }
    return expression instanceof IteratorExp<?, ?> loop
        && KEEPING.contains(loop.getName())
        && holdsAtMostOne(loop.getSource());
  }

  private static boolean isSelection(OperationCallExp<?, ?> call) {
    return call.getReferredOperation() instanceof Libraries.LibraryOperation operation
        ? operation.implementation().isSelection()
        : KEEPING.contains(name(call));
  }

  private static String name(OperationCallExp<?, ?> call) {
    return call.getReferredOperation() instanceof ENamedElement named ? named.getName() : "";
  }

  private Parts parts() {
    Parts known = parts;
    if (known == null) {
      known = Parts.of(ast);
      parts = known;
    }
    return known;
  }

  /**
   * Returns the features in the expression that only missing Java code computes: reading them gives
   * their defaults.
   */
  public List<EStructuralFeature> computedInJava() {
    return parts().computedInJava();
  }

  /**
   * Returns whether the value is the same for every object of every model, since the expression
   * mentions neither {@code self} nor a property nor a class.
   */
  public boolean isConstant() {
    return parts().constant();
  }

  /** Properties for linters, collected in one walk. */
  private record Parts(
      List<LibraryCall> calls,
      Set<String> variables,
      List<EStructuralFeature> computedInJava,
      boolean constant) {
    static Parts of(OCLExpression<EClassifier> ast) {
      List<LibraryCall> calls = new ArrayList<>();
      Set<String> variables = new TreeSet<>();
      Set<EStructuralFeature> computedInJava = new LinkedHashSet<>();
      boolean reads = false;
      Iterator<EObject> all = EcoreUtil.getAllContents(List.of(ast));
      while (all.hasNext()) {
        EObject part = all.next();
        reads |= part instanceof PropertyCallExp<?, ?> || part instanceof TypeExp<?>;
        if (part instanceof OperationCallExp<?, ?> call
            && call.getReferredOperation() instanceof Libraries.LibraryOperation operation) {
          EClassifier source = (EClassifier) call.getSource().getType();
          calls.add(new LibraryCall(source, operation.implementation()));
        } else if (part instanceof VariableExp<?, ?> variable
            && variable.getReferredVariable() != null) {
          variables.add(variable.getReferredVariable().getName());
        } else if (part instanceof PropertyCallExp<?, ?> read
            && read.getReferredProperty() instanceof EStructuralFeature feature
            && OclAnnotations.isComputedInJava(feature)) {
          computedInJava.add(feature);
        }
      }
      return new Parts(
          List.copyOf(calls),
          Collections.unmodifiableSet(variables),
          List.copyOf(computedInJava),
          !reads && !variables.contains("self"));
    }
  }

  /**
   * Evaluates.
   *
   * @param run the values of the variables in the scope of the expression; a variable that it does
   *     not bind is {@code null}
   * @return the value: {@code null} for OCL's null; an {@link Invalid} if there is none; an Integer
   *     is an {@link Integer} if it fits, else a {@link Long} or a {@link java.math.BigInteger}, a
   *     Real a {@link Double} or a {@link java.math.BigDecimal}; collections are read-only, sets
   *     and bags keep the order of insertion; a type literal gives the {@link EClassifier}
   */
  public Object evaluate(Evaluation run) {
    return evaluate(run, null, false);
  }

  /**
   * Evaluates for a caller that iterates over the value at once and keeps no reference to it. A
   * collection may be the model's own list; only its elements and their order are reliable.
   */
  public Object read(Evaluation run) {
    return evaluate(run, null, true);
  }

  /**
   * Evaluates, but passes the outermost call to a receiver instead of the library: for {@code
   * x.f()} one call, for {@code xs.f()} one per element. Results of the receiver are discarded, so
   * that it can write a large value directly to its destination.
   *
   * @return an {@link Invalid} if the expression has no value, which may be known only after some
   *     calls; otherwise {@code null}
   * @throws IllegalStateException if there is no {@link #outermostCall}
   */
  public Object evaluateCalls(Evaluation run, OperationLibrary.Implementation receiver) {
    return evaluate(run, receiver, false);
  }

  private Object evaluate(
      Evaluation evaluation, OperationLibrary.Implementation receiver, boolean read) {
    Run run = (Run) evaluation;
    Lowered known = lowered;
    if (known != null && known.isQuick() && receiver == null) {
      Object value = known.quick(run, read);
      if (value != Values.INVALID) {
        return value;
      }
    }
    int height = run.values().size();
    boolean outermost = run.begin();
    try {
      Lowered code = lowered();
      Frame frame = code.frame(run);
      Object value;
      if (receiver != null) {
        value = code.evaluateCalls(receiver, frame);
      } else {
        value = read ? code.read(frame) : code.evaluate(frame);
      }
      return value == Values.INVALID ? explain(frame) : value;
    } catch (Halted e) {
      return invalid(e.getMessage(), e.kind());
    } catch (StackOverflowError e) {
      if (!outermost) {
        throw e;
      }
      return invalid("it recurses endlessly, or too deeply", Invalid.Kind.RECURSION);
    } finally {
      run.values().truncate(height);
      run.end();
    }
  }

  /** Returns whether its definitions may be recursive, so that evaluation may need a deep stack. */
  public boolean isRecursive() {
    try {
      return lowered().isRecursive();
    } catch (StackOverflowError e) {
      return true;
    }
  }

  /**
   * Explains in words why a condition is false: the decisive values. Evaluates parts of it again.
   *
   * @param run binds the variables as for the evaluation; its time limit applies to this, too
   * @return such as {@code self.pages is 3}; empty if there is no explanation
   */
  public String whyFalse(Evaluation run) {
    SubExpressions known = subExpressions;
    if (known == null) {
      known =
          new SubExpressions(
              language.environment(), part -> new Expression(language, part)::evaluate);
      subExpressions = known;
    }
    return Explanation.whyFalse(ast, known, run);
  }

  /** Evaluates again with nodes that record where a value becomes invalid. */
  private Invalid explain(Frame frame) {
    Lowered known = traced;
    if (known == null) {
      known = language.trace(ast);
      traced = known;
    }
    Frame again = known.frame(frame.run());
    again.replay(frame.calls());
    frame.run().setOrigin(null);
    frame.run().takeFailure();
    known.evaluate(again);
    InvalidOrigin origin = frame.run().origin();
    return origin == null ? invalid("it has no value", Invalid.Kind.OTHER) : origin.toInvalid();
  }

  private Invalid invalid(String reason, Invalid.Kind kind) {
    return new Invalid(reason, location(), kind);
  }

  private Lowered lowered() {
    Lowered known = lowered;
    if (known == null) {
      known = language.lower(ast);
      lowered = known;
    }
    return known;
  }

  OCLExpression<EClassifier> ast() {
    return ast;
  }
}
