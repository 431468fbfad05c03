package dev.eventchain.ocl;

import dev.eventchain.ocl.parse.OclEnvironment;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.ecore.EcoreEnvironmentFactory;
import org.eclipse.ocl.ecore.EcoreEvaluationEnvironment;
import org.eclipse.ocl.ecore.EvaluationVisitorImpl;
import org.eclipse.ocl.expressions.CollectionLiteralExp;
import org.eclipse.ocl.expressions.CollectionLiteralPart;
import org.eclipse.ocl.expressions.CollectionRange;
import org.eclipse.ocl.expressions.IteratorExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.PropertyCallExp;
import org.eclipse.ocl.expressions.TupleLiteralExp;
import org.eclipse.ocl.expressions.UnlimitedNaturalLiteralExp;
import org.eclipse.ocl.types.BagType;
import org.eclipse.ocl.types.SetType;
import org.eclipse.ocl.types.TupleType;

/**
 * Eclipse OCL's own evaluator, with its own environments, for expressions from our parser. It gets
 * the numbers of a model as OCL's, whatever their Java types, and records {@link StockDifferences}.
 */
final class StockEvaluator {

  private final OclEnvironment environment;
  private final Set<String> differences = new TreeSet<>();

  /** Occurrence of the unlimited number in the latest evaluation. */
  private boolean unlimited;

  StockEvaluator(OclEnvironment environment) {
    this.environment = environment;
  }

  /** Returns the differences from the standard in the latest evaluation. */
  Set<String> differences() {
    return differences;
  }

  Object evaluate(OCLExpression<EClassifier> expression, EObject self) {
    return evaluate(expression, self, Map.of());
  }

  Object evaluate(
      OCLExpression<EClassifier> expression, EObject self, Map<String, Object> variables) {
    differences.clear();
    unlimited = false;
    EcoreEvaluationEnvironment values =
        new Environment((EcoreEnvironmentFactory) environment.getFactory());
    values.add("self", self);
    variables.forEach(values::add);
    return new Visitor(values, values.createExtentMap(self)).visitExpression(expression);
  }

  private static final class Environment extends EcoreEvaluationEnvironment {
    Environment(EcoreEnvironmentFactory factory) {
      super(factory);
    }

    Environment(EcoreEvaluationEnvironment parent) {
      super(parent);
    }

    @Override
    public Object navigateProperty(EStructuralFeature property, List<?> qualifiers, Object target) {
      return StockDifferences.asNumberOfOcl(super.navigateProperty(property, qualifiers, target));
    }
  }

  private final class Visitor extends EvaluationVisitorImpl {
    private final EcoreEvaluationEnvironment values;
    private final Map<EClass, Set<EObject>> extents;

    /** The values of the parts of each call or loop that is being evaluated. */
    private final Deque<Map<Object, Object>> parts =
        new ArrayDeque<>(List.of(new IdentityHashMap<>()));

    Visitor(EcoreEvaluationEnvironment values, Map<EClass, Set<EObject>> extents) {
      super(environment, values, extents);
      this.values = values;
      this.extents = extents;
    }

    @Override
    protected Object safeVisitExpression(OCLExpression<EClassifier> expression) {
      return noted(expression, super.safeVisitExpression(expression));
    }

    @Override
    public Object visitExpression(OCLExpression<EClassifier> expression) {
      return noted(expression, super.visitExpression(expression));
    }

    private Object noted(OCLExpression<EClassifier> expression, Object value) {
      StockDifferences.ofValue(value).ifPresent(differences::add);
      unlimited |=
          expression instanceof UnlimitedNaturalLiteralExp<?> literal && literal.isUnlimited();
      // Each element of a loop has a value of the body.
      boolean first = !parts.element().containsKey(expression);
      parts.element().put(first ? expression : new Object(), value);
      return value;
    }

    @Override
    public Object visitOperationCallExp(OperationCallExp<EClassifier, EOperation> call) {
      parts.push(new IdentityHashMap<>());
      try {
        return super.visitOperationCallExp(call);
      } finally {
        Map<Object, Object> known = parts.pop();
        Object source = known.get(call.getSource());
        StockDifferences.ofCall(call.getOperationCode(), source, known.values())
            .ifPresent(differences::add);
        StockDifferences.ofUnlimited(unlimited, known.values()).ifPresent(differences::add);
      }
    }

    @Override
    public Object visitPropertyCallExp(PropertyCallExp<EClassifier, EStructuralFeature> call) {
      Object value = super.visitPropertyCallExp(call);
      if (call.getSource().getType() instanceof TupleType) {
        StockDifferences.ofPart(value).ifPresent(differences::add);
      }
      return value;
    }

    /** Notes sets that are the sources of loops, and ends of ranges, which are not noted there. */
    @Override
    public Object visitCollectionLiteralExp(CollectionLiteralExp<EClassifier> literal) {
      for (CollectionLiteralPart<EClassifier> part : literal.getPart()) {
        if (part instanceof CollectionRange<EClassifier> range) {
          List<OCLExpression<EClassifier>> ends = List.of(range.getFirst(), range.getLast());
          StockDifferences.ofNumbers(ends.stream().map(this::safeVisitExpression).toList())
              .ifPresent(differences::add);
        }
      }
      Object value = super.visitCollectionLiteralExp(literal);
      StockDifferences.ofValue(value).ifPresent(differences::add);
      return value;
    }

    @Override
    public Object visitTupleLiteralExp(TupleLiteralExp<EClassifier, EStructuralFeature> literal) {
      try {
        return super.visitTupleLiteralExp(literal);
      } catch (RuntimeException e) {
        differences.add(StockDifferences.FAILING_PART);
        throw e;
      }
    }

    @Override
    public Object visitIteratorExp(IteratorExp<EClassifier, EParameter> loop) {
      parts.push(new IdentityHashMap<>());
      try {
        return super.visitIteratorExp(loop);
      } finally {
        Map<Object, Object> known = parts.pop();
        EClassifier source = loop.getSource().getType();
        boolean unordered = source instanceof SetType || source instanceof BagType;
        StockDifferences.ofLoop(loop.getName(), unordered, known.values())
            .ifPresent(differences::add);
      }
    }

    /** Calls like the original, which would create the nested environment from ours. */
    @Override
    protected Object call(
        EOperation operation, OCLExpression<EClassifier> body, Object target, Object[] args) {
      EcoreEvaluationEnvironment nested = new Environment(values);
      nested.add("self", target);
      List<EParameter> parameters = operation.getEParameters();
      for (int i = 0; i < args.length; i++) {
        nested.add(parameters.get(i).getName(), args[i]);
      }
      return new Visitor(nested, extents).visitExpression(body);
    }

    @Override
    protected Object navigate(
        EStructuralFeature property, OCLExpression<EClassifier> derivation, Object target) {
      EcoreEvaluationEnvironment nested = new Environment(values);
      nested.add("self", target);
      return new Visitor(nested, extents).visitExpression(derivation);
    }
  }
}
