package dev.eventchain.ocl;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import org.eclipse.emf.ecore.EAnnotation;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EModelElement;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.EvaluationHaltedException;
import org.eclipse.ocl.ecore.EvaluationVisitorImpl;
import org.eclipse.ocl.expressions.CollectionItem;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.expressions.CollectionLiteralExp;
import org.eclipse.ocl.expressions.CollectionLiteralPart;
import org.eclipse.ocl.expressions.CollectionRange;
import org.eclipse.ocl.expressions.IfExp;
import org.eclipse.ocl.expressions.IntegerLiteralExp;
import org.eclipse.ocl.expressions.InvalidLiteralExp;
import org.eclipse.ocl.expressions.IterateExp;
import org.eclipse.ocl.expressions.IteratorExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.PropertyCallExp;
import org.eclipse.ocl.parser.AbstractOCLAnalyzer;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.types.TupleType;
import org.eclipse.ocl.util.OCLStandardLibraryUtil;
import org.eclipse.ocl.util.Tuple;
import org.eclipse.ocl.utilities.PredefinedType;

/**
 * Eclipse OCL's evaluator with the same results, except that sets and bags keep their order. It
 * also calls library operations, remembers what made a value invalid, and stops what does not end.
 */
final class Evaluator extends EvaluationVisitorImpl {

  private final Evaluation run;
  private final LibraryCalls calls;
  private final Overriding overriding;

  Evaluator(
      OclEnvironment environment,
      ValueEnvironment values,
      Map<? extends EClass, ? extends Set<? extends EObject>> extents) {
    super(environment, values, extents);
    this.run = values.run();
    this.calls = values.calls();
    this.overriding = new Overriding(environment);
  }

  @Override
  public Object visitExpression(OCLExpression<EClassifier> expression) {
    return safeVisitExpression(expression);
  }

  /** Evaluates; an exception makes the value invalid and is remembered as the reason. */
  @Override
  protected Object safeVisitExpression(OCLExpression<EClassifier> expression) {
    try {
      return expression.accept(getVisitor());
    } catch (EvaluationHaltedException e) {
      throw e;
    } catch (RuntimeException e) {
      if (run.origin() == null) {
        run.setOrigin(new InvalidOrigin(expression, null, messageOf(e), e));
      }
      return getInvalid();
    }
  }

  static String messageOf(RuntimeException e) {
    return e.getMessage() == null
        ? "it cannot be evaluated"
        : e.getMessage().lines().findFirst().orElse("");
  }

  /**
   * Evaluates a node, and if it is the innermost one that is invalid, remembers it.
   *
   * @param subject what the node is applied to, only evaluated again if so
   */
  private Object tracked(
      OCLExpression<EClassifier> node,
      Supplier<Object> evaluation,
      OCLExpression<EClassifier> subject) {
    run.step();
    InvalidOrigin before = run.origin();
    run.setOrigin(null);
    Object result;
    String detail = "";
    RuntimeException cause = null;
    try {
      result = evaluation.get();
    } catch (EvaluationHaltedException e) {
      throw e;
    } catch (RuntimeException e) {
      result = getInvalid();
      detail = messageOf(e);
      cause = e;
    }
    if (result != getInvalid()) {
      run.setOrigin(before);
    } else if (run.origin() == null) {
      Object source = subject == null ? null : safeVisitExpression(subject);
      String note = run.takeFailure().detail();
      run.setOrigin(new InvalidOrigin(node, source, detail.isEmpty() ? note : detail, cause));
    }
    return result;
  }

  @Override
  public Object visitOperationCallExp(OperationCallExp<EClassifier, EOperation> call) {
    return tracked(call, () -> Limits.require(operation(call)), call.getSource());
  }

  @Override
  public Object visitPropertyCallExp(PropertyCallExp<EClassifier, EStructuralFeature> call) {
    boolean ofTuple = call.getSource().getType() instanceof TupleType<?, ?>;
    return tracked(
        call, () -> ofTuple ? part(call) : super.visitPropertyCallExp(call), call.getSource());
  }

  /** The original makes a collection, with nothing invalid about it, of a part that is invalid. */
  private Object part(PropertyCallExp<EClassifier, EStructuralFeature> call) {
    Object tuple = safeVisitExpression(call.getSource());
    return tuple instanceof Tuple<?, ?>
        ? getEvaluationEnvironment().navigateProperty(call.getReferredProperty(), List.of(), tuple)
        : Node.INVALID;
  }

  @Override
  public Object visitIteratorExp(IteratorExp<EClassifier, EParameter> loop) {
    return tracked(loop, () -> iterator(loop), loop.getSource());
  }

  @Override
  public Object visitIterateExp(IterateExp<EClassifier, EParameter> loop) {
    return tracked(loop, () -> super.visitIterateExp(loop), loop.getSource());
  }

  @Override
  public Object visitIfExp(IfExp<EClassifier> choice) {
    return tracked(choice, () -> super.visitIfExp(choice), choice.getCondition());
  }

  @Override
  public Object visitIntegerLiteralExp(IntegerLiteralExp<EClassifier> literal) {
    return BigLiterals.valueOf(literal);
  }

  @Override
  public Object visitInvalidLiteralExp(InvalidLiteralExp<EClassifier> literal) {
    return tracked(literal, () -> super.visitInvalidLiteralExp(literal), null);
  }

  private Object operation(OperationCallExp<EClassifier, EOperation> call) {
    if (call.getReferredOperation() instanceof Libraries.LibraryOperation operation) {
      return libraryOperation(call, operation);
    }
    int code = call.getOperationCode();
    if (code == PredefinedType.OCL_AS_SET) {
      return asSet(safeVisitExpression(call.getSource()));
    } else if (code == PredefinedType.ALL_INSTANCES
        && call.getSource().accept(getVisitor()) instanceof EEnum enumeration) {
      return StandardOperations.literals(enumeration);
    } else if (call.getSource().getType() instanceof CollectionType<?, ?>
        && CollectionCalls.makesCollection(code)) {
      return collectionOperation(call, code);
    }
    return CollectionOperations.distinct(
        StandardOperations.differs(code) ? asStandard(call) : super.visitOperationCallExp(call));
  }

  /** A part of an expression as a node. */
  private Node visited(OCLExpression<EClassifier> expression) {
    return new Node() {
      @Override
      Object evaluate(Frame frame) {
        return safeVisitExpression(expression);
      }
    };
  }

  /** As the same operation has it in lowered expressions. */
  private Object asStandard(OperationCallExp<EClassifier, EOperation> call) {
    Node source = visited(call.getSource());
    Node[] arguments = call.getArgument().stream().map(this::visited).toArray(Node[]::new);
    Node node =
        new StandardOperations(
                (OclEnvironment) getEnvironment(), (ValueEnvironment) getEvaluationEnvironment())
            .node(call, source, arguments);
    return node == null ? super.visitOperationCallExp(call) : node.evaluate(new Frame(run, 0));
  }

  private Object asSet(Object source) {
    if (source == getInvalid()) {
      return source;
    }
    Set<Object> result = new InsertionOrderedSet<>();
    if (source != null) {
      result.add(source);
    }
    return result;
  }

  private Object libraryOperation(
      OperationCallExp<EClassifier, EOperation> call, Libraries.LibraryOperation operation) {
    Object source = safeVisitExpression(call.getSource());
    if (source == getInvalid()) {
      return source;
    }
    List<Object> arguments = new ArrayList<>(call.getArgument().size());
    for (OCLExpression<EClassifier> argument : call.getArgument()) {
      Object value = safeVisitExpression(argument);
      if (value == getInvalid()) {
        return value;
      }
      arguments.add(value);
    }
    // What the library evaluates on the way must not pass for the reason of this result.
    Object result = calls.call(call, operation.implementation(), source, arguments.toArray(), run);
    run.setOrigin(null);
    if (result instanceof Invalid invalid) {
      run.setOrigin(new InvalidOrigin(call, source, invalid.reason(), invalid.cause()));
      return getInvalid();
    }
    return CollectionOperations.conform(Values.normal(result), call.getType());
  }

  private Object collectionOperation(OperationCallExp<EClassifier, EOperation> call, int code) {
    Object source = safeVisitExpression(call.getSource());
    if (isUndefined(source)) {
      return getInvalid();
    }
    if (call.getArgument().isEmpty()) {
      return CollectionCalls.unary(code, (Collection<?>) source);
    }
    Object argument = safeVisitExpression(call.getArgument().get(0));
    if (argument == getInvalid()) {
      return argument;
    }
    Collection<?> elements = (Collection<?>) source;
    return switch (code) {
      case PredefinedType.PRODUCT ->
          argument == null ? getInvalid() : product(call, elements, (Collection<?>) argument);
      case PredefinedType.SELECT_BY_KIND -> selectByType(elements, argument, false);
      case PredefinedType.SELECT_BY_TYPE -> selectByType(elements, argument, true);
      case PredefinedType.INCLUDING -> CollectionOperations.including(elements, argument);
      case PredefinedType.EXCLUDING -> CollectionOperations.excluding(elements, argument);
      default ->
          argument == null
              ? getInvalid()
              : CollectionCalls.binary(code, elements, (Collection<?>) argument);
    };
  }

  private Object product(
      OperationCallExp<EClassifier, EOperation> call, Collection<?> first, Collection<?> second) {
    return Product.of(call, (OclEnvironment) getEnvironment())
        .make(first, second, (ValueEnvironment) getEvaluationEnvironment(), run);
  }

  private Object selectByType(Collection<?> elements, Object type, boolean exactly) {
    Collection<Object> result = CollectionOperations.create(CollectionOperations.kindOf(elements));
    for (Object element : elements) {
      Boolean matches =
          exactly
              ? oclIsTypeOf(element, type)
              : Boolean.valueOf(element != null && oclIsKindOf(element, type));
      if (Boolean.TRUE.equals(matches)) {
        result.add(element);
      }
    }
    return result;
  }

  private Object iterator(IteratorExp<EClassifier, EParameter> loop) {
    int code = OCLStandardLibraryUtil.getOperationCode(loop.getName());
    boolean unlimited =
        code == PredefinedType.SORTED_BY
            && StandardOperations.isUnlimited(loop.getBody().getType());
    boolean single = loop.getIterator().size() == 1 || LoopEvaluator.isQuantifier(code);
    if (!LoopEvaluator.has(code) || !single || unlimited) {
      return super.visitIteratorExp(loop);
    }
    Object source = loop.getSource().accept(getVisitor());
    return isUndefined(source)
        ? getInvalid()
        : new LoopEvaluator(this, loop).evaluate(code, (Collection<?>) source);
  }

  /** The value that stands for OCL's invalid inside the evaluator. */
  Object invalid() {
    return getInvalid();
  }

  @Override
  public Object visitCollectionLiteralExp(CollectionLiteralExp<EClassifier> literal) {
    CollectionKind kind = literal.getKind();
    if (kind == CollectionKind.SEQUENCE_LITERAL && literal.isSimpleRange()) {
      CollectionRange<EClassifier> range = (CollectionRange<EClassifier>) literal.getPart().get(0);
      return new ValueNodes.SequenceRange(visited(range.getFirst()), visited(range.getLast()))
          .evaluate(new Frame(run, 0));
    }
    Collection<Object> result = CollectionOperations.create(kind);
    for (CollectionLiteralPart<EClassifier> part : literal.getPart()) {
      if (part instanceof CollectionItem<EClassifier> item) {
        Object value = item.getItem().accept(getVisitor());
        if (value == getInvalid()) {
          return value;
        }
        if (value != null || literal.getPart().size() > 1 || !isImplicit(literal)) {
          result.add(value);
        }
      } else {
        CollectionRange<EClassifier> range = (CollectionRange<EClassifier>) part;
        if (!addRange(range, result)) {
          return getInvalid();
        }
      }
    }
    return result;
  }

  private boolean addRange(CollectionRange<EClassifier> range, Collection<Object> result) {
    return new ValueNodes.Range(visited(range.getFirst()), visited(range.getLast()))
        .addTo(result, new Frame(run, 0));
  }

  /** Whether the set was made because an arrow follows a single value. */
  static boolean isImplicit(CollectionLiteralExp<EClassifier> literal) {
    EAnnotation annotation =
        literal instanceof EModelElement element
            ? element.getEAnnotation(AbstractOCLAnalyzer.OCL_ANNOTATIONS_URI)
            : null;
    return annotation != null
        && Boolean.parseBoolean(
            annotation.getDetails().get(AbstractOCLAnalyzer.IMPLICIT_SET_CONVERSION));
  }

  /** Eclipse OCL would look for annotations by itself, of which it knows only some. */
  @Override
  protected OCLExpression<EClassifier> getOperationBody(EOperation operation) {
    return ((OclEnvironment) getEnvironment()).bodyOf(operation);
  }

  @Override
  protected OCLExpression<EClassifier> getPropertyBody(EStructuralFeature property) {
    return ((OclEnvironment) getEnvironment()).bodyOf(property);
  }

  @Override
  protected Map<String, Matcher> createRegexCache() {
    return run.matchers();
  }

  @Override
  protected Object call(
      EOperation operation, OCLExpression<EClassifier> body, Object target, Object[] args) {
    EOperation own = operation;
    if (target instanceof EObject object) {
      own = (EOperation) overriding.select(operation, object.eClass());
    }
    run.enterDefinition();
    try {
      return super.call(own, own == operation ? body : getOperationBody(own), target, args);
    } finally {
      run.leaveDefinition();
    }
  }

  @Override
  protected Object navigate(
      EStructuralFeature property, OCLExpression<EClassifier> derivation, Object target) {
    EStructuralFeature own = property;
    if (target instanceof EObject object) {
      own = (EStructuralFeature) overriding.select(property, object.eClass());
    }
    run.enterDefinition();
    try {
      return super.navigate(own, own == property ? derivation : getPropertyBody(own), target);
    } finally {
      run.leaveDefinition();
    }
  }
}
