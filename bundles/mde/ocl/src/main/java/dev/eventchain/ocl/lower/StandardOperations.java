package dev.eventchain.ocl.lower;

import dev.eventchain.ocl.model.ModelAccess;
import dev.eventchain.ocl.model.TypeTest;
import dev.eventchain.ocl.nodes.CollectionNodes;
import dev.eventchain.ocl.nodes.DefinitionNodes;
import dev.eventchain.ocl.nodes.LogicNodes;
import dev.eventchain.ocl.nodes.NavigationNodes;
import dev.eventchain.ocl.nodes.Node;
import dev.eventchain.ocl.nodes.NumberNodes;
import dev.eventchain.ocl.nodes.Product;
import dev.eventchain.ocl.nodes.SummaryNodes;
import dev.eventchain.ocl.nodes.TextNodes;
import dev.eventchain.ocl.nodes.ValueNodes;
import dev.eventchain.ocl.parse.OclEnvironment;
import dev.eventchain.ocl.values.InsertionOrderedSet;
import java.util.Collections;
import java.util.Set;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.TypeExp;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.types.OCLStandardLibrary;
import org.eclipse.ocl.types.VoidType;
import org.eclipse.ocl.util.OCLStandardLibraryUtil;
import org.eclipse.ocl.utilities.PredefinedType;

/** Creates the nodes of standard library operations. */
final class StandardOperations {

  private final OclEnvironment environment;
  private final ModelAccess values;
  private final OCLStandardLibrary<EClassifier> types;

  StandardOperations(OclEnvironment environment, ModelAccess values) {
    this.environment = environment;
    this.values = values;
    this.types = environment.getOCLStandardLibrary();
  }

  /** Returns the node of an operation of the standard library. */
  Node node(OperationCallExp<EClassifier, EOperation> call, Node source, Node[] arguments) {
    EClassifier type = environment.getUMLReflection().asOCLType(call.getSource().getType());
    Node node = ofAnything(call, type, source, arguments);
    if (node == null && type instanceof CollectionType<?, ?> collection) {
      node = ofCollection(call, collection, source, arguments);
    } else if (node == null && NumberNodes.Comparison.has(call.getOperationCode())) {
      node = NumberNodes.Comparison.of(call.getOperationCode(), source, arguments[0]);
    } else if (node == null && type == types.getString()) {
      node = ofString(call.getOperationCode(), source, arguments);
    } else if (node == null && isNumeric(type)) {
      node = ofNumber(call.getOperationCode(), source, arguments);
    }
    // All others are invalid for any source, such as the sum of invalid and one.
    return node == null ? new ValueNodes.Undefined(source) : node;
  }

  private boolean isNumeric(EClassifier type) {
    return type == types.getInteger()
        || type == types.getReal()
        || type == types.getUnlimitedNatural();
  }

  private Node ofAnything(
      OperationCallExp<EClassifier, EOperation> call,
      EClassifier type,
      Node source,
      Node[] arguments) {
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
      case PredefinedType.TO_STRING -> new TextNodes.ToString(source);
      case PredefinedType.ALL_INSTANCES -> allInstances(call.getSource());
      case PredefinedType.OCL_IS_KIND_OF ->
          new NavigationNodes.IsOfType(source, new TypeTest(argumentType(call), false, values));
      case PredefinedType.OCL_IS_TYPE_OF ->
          new NavigationNodes.IsOfType(source, new TypeTest(argumentType(call), true, values));
      case PredefinedType.OCL_AS_TYPE -> asType(type, argumentType(call), source);
      default -> null;
    };
  }

  /** Returns the type that an argument names; the grammar allows no other argument there. */
  private static EClassifier argumentType(OperationCallExp<EClassifier, EOperation> call) {
    return ((TypeExp<EClassifier>) call.getArgument().get(0)).getReferredType();
  }

  /** Returns the extent of a type; empty for types such as Integer, as in Eclipse OCL. */
  private static Node allInstances(OCLExpression<EClassifier> source) {
    EClassifier type = ((TypeExp<EClassifier>) source).getReferredType();
    if (type instanceof EEnum enumeration) {
      return new ValueNodes.Constant(literals(enumeration));
    } else if (type instanceof VoidType<?>) {
      return new ValueNodes.Constant(new InsertionOrderedSet<>(Collections.singleton(null)));
    }
    return type instanceof EClass found
        ? new NavigationNodes.AllInstances(found)
        : new ValueNodes.Constant(new InsertionOrderedSet<>(Set.of()));
  }

  /** Returns the values of an enumeration, as features have them. */
  static Set<Object> literals(EEnum enumeration) {
    Set<Object> values = new InsertionOrderedSet<>();
    enumeration.getELiterals().forEach(literal -> values.add(literal.getInstance()));
    return values;
  }

  private Node asType(EClassifier from, EClassifier to, Node source) {
    boolean toReal = from == types.getInteger() && to == types.getReal();
    return toReal ? new NumberNodes.AsReal(source) : new NavigationNodes.AsType(source, to, values);
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
      return new SummaryNodes.Size(source);
    } else if (code == PredefinedType.IS_EMPTY || code == PredefinedType.NOT_EMPTY) {
      boolean wanted = code == PredefinedType.IS_EMPTY;
      return source instanceof ValueNodes.ImplicitSet single
          ? new SummaryNodes.IsAbsent(single.item(), wanted)
          : new SummaryNodes.IsEmpty(source, wanted);
    } else if (CollectionNodes.Conversion.has(code)) {
      return new CollectionNodes.Conversion(code, source);
    }
    if (source instanceof DefinitionNodes.LibraryCall made
        && (code == PredefinedType.FIRST || code == PredefinedType.LAST)) {
      return new SummaryNodes.Aggregate(
          code, made.endOnly(environment.dialect(), code == PredefinedType.FIRST), null);
    }
    return SummaryNodes.Aggregate.has(code)
        ? new SummaryNodes.Aggregate(code, source, emptySum(type))
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
      return new SummaryNodes.Includes(source, argument, code == PredefinedType.INCLUDES, integers);
    } else if (CollectionNodes.Pair.has(code)) {
      return new CollectionNodes.Pair(code, source, argument);
    } else if (CollectionNodes.WithElement.has(code)) {
      return new CollectionNodes.WithElement(code, source, argument);
    } else if (code == PredefinedType.PRODUCT) {
      return new CollectionNodes.ProductNode(source, argument, product(call), values);
    } else if (code == PredefinedType.SELECT_BY_KIND || code == PredefinedType.SELECT_BY_TYPE) {
      boolean exactly = code == PredefinedType.SELECT_BY_TYPE;
      return new CollectionNodes.SelectByType(
          source, new TypeTest(argumentType(call), exactly, values));
    }
    return null;
  }

  private Product product(OperationCallExp<EClassifier, EOperation> call) {
    EClassifier type = ((org.eclipse.ocl.ecore.CollectionType) call.getType()).getElementType();
    return new Product(
        type,
        environment.lookupProperty(type, OCLStandardLibraryUtil.PRODUCT_FIRST),
        environment.lookupProperty(type, OCLStandardLibraryUtil.PRODUCT_SECOND));
  }

  private static Node ofString(int code, Node source, Node[] arguments) {
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

  private static Node ofNumber(int code, Node source, Node[] arguments) {
    if (arguments.length == 0) {
      return NumberNodes.Unary.has(code) ? new NumberNodes.Unary(code, source) : null;
    }
    return NumberNodes.Arithmetic.has(code)
        ? new NumberNodes.Arithmetic(code, source, arguments[0])
        : null;
  }
}
