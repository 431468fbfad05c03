package dev.eventchain.ocl;

import java.util.Set;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.TypeExp;
import org.eclipse.ocl.types.AnyType;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.types.OCLStandardLibrary;
import org.eclipse.ocl.types.PrimitiveType;
import org.eclipse.ocl.types.VoidType;
import org.eclipse.ocl.utilities.PredefinedType;

/** Makes the nodes of the operations of the standard library. */
final class StandardOperations {

  private static final Set<Integer> DIFFERENT =
      Set.of(
          PredefinedType.EQUAL,
          PredefinedType.NOT_EQUAL,
          PredefinedType.LESS_THAN,
          PredefinedType.LESS_THAN_EQUAL,
          PredefinedType.GREATER_THAN,
          PredefinedType.GREATER_THAN_EQUAL,
          PredefinedType.PLUS,
          PredefinedType.MINUS,
          PredefinedType.TIMES,
          PredefinedType.DIVIDE,
          PredefinedType.DIV,
          PredefinedType.MOD,
          PredefinedType.MAX,
          PredefinedType.MIN,
          PredefinedType.ABS,
          PredefinedType.FLOOR,
          PredefinedType.ROUND,
          PredefinedType.SUM,
          PredefinedType.COUNT,
          PredefinedType.INCLUDES,
          PredefinedType.EXCLUDES,
          PredefinedType.INCLUDES_ALL,
          PredefinedType.EXCLUDES_ALL,
          PredefinedType.INDEX_OF,
          PredefinedType.TO_INTEGER,
          PredefinedType.TO_REAL,
          PredefinedType.AS_ORDERED_SET,
          PredefinedType.OCL_IS_KIND_OF,
          PredefinedType.OCL_IS_TYPE_OF,
          PredefinedType.OCL_AS_TYPE);

  private final OclEnvironment environment;
  private final ValueEnvironment values;
  private final OCLStandardLibrary<EClassifier> types;

  StandardOperations(OclEnvironment environment, ValueEnvironment values) {
    this.environment = environment;
    this.values = values;
    this.types = environment.getOCLStandardLibrary();
  }

  static boolean isUnlimited(EClassifier type) {
    return type instanceof PrimitiveType<?> primitive
        && primitive.getName().equals(PrimitiveType.UNLIMITED_NATURAL_NAME);
  }

  /** Whether Eclipse OCL has another value for an operation than the standard, for some values. */
  static boolean differs(int code) {
    return DIFFERENT.contains(code);
  }

  /** An operation of the standard library; null if it has no node. */
  Node node(OperationCallExp<EClassifier, EOperation> call, Node source, Node[] arguments) {
    EClassifier type = call.getSource().getType();
    Node node = ofAnything(call, source, arguments);
    if (node != null) {
      return node;
    } else if (isUnlimited(type)
        || call.getArgument().stream().anyMatch(argument -> isUnlimited(argument.getType()))) {
      return null;
    } else if (type instanceof CollectionType<?, ?> collection) {
      return ofCollection(call, collection, source, arguments);
    } else if (type == types.getString()) {
      return ofString(call, source, arguments);
    } else if (type == types.getInteger() || type == types.getReal()) {
      return ofNumber(call, source, arguments);
    }
    return null;
  }

  private Node ofAnything(
      OperationCallExp<EClassifier, EOperation> call, Node source, Node[] arguments) {
    int code = call.getOperationCode();
    return switch (code) {
      case PredefinedType.AND -> new LogicNodes.And(source, arguments[0]);
      case PredefinedType.OR -> new LogicNodes.Or(source, arguments[0]);
      case PredefinedType.IMPLIES -> new LogicNodes.Implies(source, arguments[0]);
      case PredefinedType.XOR -> new LogicNodes.Xor(source, arguments[0]);
      case PredefinedType.NOT -> new LogicNodes.Not(source);
      case PredefinedType.EQUAL, PredefinedType.NOT_EQUAL ->
          new LogicNodes.Equality(source, arguments[0], code == PredefinedType.EQUAL);
      case PredefinedType.OCL_IS_UNDEFINED -> new LogicNodes.IsUndefined(source, true);
      case PredefinedType.OCL_IS_INVALID -> new LogicNodes.IsUndefined(source, false);
      case PredefinedType.OCL_AS_SET -> new ValueNodes.ImplicitSet(source);
      case PredefinedType.TO_STRING ->
          isUnlimited(call.getSource().getType()) ? null : new TextNodes.ToString(source);
      case PredefinedType.ALL_INSTANCES -> allInstances(call.getSource());
      case PredefinedType.OCL_IS_KIND_OF, PredefinedType.OCL_IS_TYPE_OF -> isOfType(call, source);
      case PredefinedType.OCL_AS_TYPE -> asType(call, source);
      default -> null;
    };
  }

  private static Node allInstances(OCLExpression<EClassifier> source) {
    if (!(source instanceof TypeExp<EClassifier> type)) {
      return null;
    } else if (type.getReferredType() instanceof EEnum enumeration) {
      return new ValueNodes.Constant(literals(enumeration));
    }
    return type.getReferredType() instanceof EClass found
            && !(type.getReferredType() instanceof VoidType<?>)
        ? new NavigationNodes.AllInstances(found)
        : null;
  }

  /** The values of an enumeration, as features have them. */
  static Set<Object> literals(EEnum enumeration) {
    Set<Object> values = new InsertionOrderedSet<>();
    enumeration.getELiterals().forEach(literal -> values.add(literal.getInstance()));
    return values;
  }

  private Node isOfType(OperationCallExp<EClassifier, EOperation> call, Node source) {
    boolean exactly = call.getOperationCode() == PredefinedType.OCL_IS_TYPE_OF;
    return call.getArgument().get(0) instanceof TypeExp<EClassifier> type
            && !isUnlimited(call.getSource().getType())
        ? new NavigationNodes.IsOfType(
            source, new TypeTest(type.getReferredType(), exactly, values))
        : null;
  }

  /** Conversions of numbers, strings and collections have rules of their own. */
  private Node asType(OperationCallExp<EClassifier, EOperation> call, Node source) {
    EClassifier from = call.getSource().getType();
    return call.getArgument().get(0) instanceof TypeExp<EClassifier> type
            && (from instanceof AnyType<?>
                || (from instanceof EClass && !(from instanceof PredefinedType<?>)))
        ? new NavigationNodes.AsType(source, type.getReferredType(), values)
        : null;
  }

  private Node ofCollection(
      OperationCallExp<EClassifier, EOperation> call,
      CollectionType<?, ?> type,
      Node source,
      Node[] arguments) {
    int code = call.getOperationCode();
    return switch (arguments.length) {
      case 0 -> ofCollection(code, type, source);
      case 1 -> ofCollection(call, source, arguments[0]);
      default ->
          CollectionNodes.Positional.has(code)
              ? new CollectionNodes.Positional(code, source, arguments[0], arguments[1])
              : null;
    };
  }

  private Node ofCollection(int code, CollectionType<?, ?> type, Node source) {
    if (code == PredefinedType.SIZE) {
      return new CollectionNodes.Size(source);
    } else if (code == PredefinedType.IS_EMPTY || code == PredefinedType.NOT_EMPTY) {
      boolean wanted = code == PredefinedType.IS_EMPTY;
      return source instanceof ValueNodes.ImplicitSet single
          ? new CollectionNodes.IsAbsent(single.item(), wanted)
          : new CollectionNodes.IsEmpty(source, wanted);
    } else if (CollectionNodes.Conversion.has(code)) {
      return new CollectionNodes.Conversion(code, source);
    }
    if (source instanceof DefinitionNodes.LibraryCall made
        && (code == PredefinedType.FIRST || code == PredefinedType.LAST)) {
      return new CollectionNodes.Aggregate(
          code, made.endOnly(environment.dialect(), code == PredefinedType.FIRST), null);
    }
    return CollectionNodes.Aggregate.has(code)
        ? new CollectionNodes.Aggregate(code, source, emptySum(type))
        : null;
  }

  private Object emptySum(CollectionType<?, ?> type) {
    if (type.getElementType() == types.getReal()) {
      return 0.0;
    }
    return type.getElementType() == types.getInteger() ? 0 : null;
  }

  private Node ofCollection(
      OperationCallExp<EClassifier, EOperation> call, Node source, Node argument) {
    int code = call.getOperationCode();
    if (code == PredefinedType.INCLUDES || code == PredefinedType.EXCLUDES) {
      boolean integers =
          call.getArgument().get(0).getType() == types.getInteger()
              && call.getSource().getType() instanceof CollectionType<?, ?> type
              && type.getElementType() == types.getInteger();
      return new CollectionNodes.Includes(
          source, argument, code == PredefinedType.INCLUDES, integers);
    } else if (CollectionNodes.Pair.has(code)) {
      return new CollectionNodes.Pair(code, source, argument);
    } else if (CollectionNodes.WithElement.has(code)) {
      return new CollectionNodes.WithElement(code, source, argument);
    } else if (code == PredefinedType.PRODUCT) {
      return new CollectionNodes.ProductNode(
          source, argument, Product.of(call, environment), values);
    } else if (code == PredefinedType.SELECT_BY_KIND || code == PredefinedType.SELECT_BY_TYPE) {
      return call.getArgument().get(0) instanceof TypeExp<EClassifier> type
          ? new CollectionNodes.SelectByType(
              source,
              new TypeTest(type.getReferredType(), code == PredefinedType.SELECT_BY_TYPE, values))
          : null;
    }
    return null;
  }

  private Node ofString(
      OperationCallExp<EClassifier, EOperation> call, Node source, Node[] arguments) {
    int code = call.getOperationCode();
    if (arguments.length == 1 && NumberNodes.Comparison.has(code)) {
      return NumberNodes.Comparison.of(code, source, arguments[0]);
    }
    return switch (arguments.length) {
      case 0 -> TextNodes.Unary.has(code) ? new TextNodes.Unary(code, source) : null;
      case 1 ->
          TextNodes.Binary.has(code) ? new TextNodes.Binary(code, source, arguments[0]) : null;
      default ->
          TextNodes.Ternary.has(code)
              ? new TextNodes.Ternary(code, source, arguments[0], arguments[1])
              : null;
    };
  }

  private Node ofNumber(
      OperationCallExp<EClassifier, EOperation> call, Node source, Node[] arguments) {
    int code = call.getOperationCode();
    if (arguments.length == 0) {
      return NumberNodes.Unary.has(code) ? new NumberNodes.Unary(code, source) : null;
    } else if (NumberNodes.Comparison.has(code)) {
      return NumberNodes.Comparison.of(code, source, arguments[0]);
    }
    return NumberNodes.Arithmetic.has(code)
        ? new NumberNodes.Arithmetic(code, source, arguments[0])
        : null;
  }
}
