package dev.eventchain.ocl;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.ecore.EcoreEnvironmentFactory;
import org.eclipse.ocl.ecore.EcoreEvaluationEnvironment;
import org.eclipse.ocl.ecore.EvaluationVisitorImpl;
import org.eclipse.ocl.expressions.OCLExpression;

/** Eclipse OCL's own evaluator, with its own environments, on expressions that we have parsed. */
final class StockEvaluator {

  private final OclEnvironment environment;

  StockEvaluator(OclEnvironment environment) {
    this.environment = environment;
  }

  Object evaluate(OCLExpression<EClassifier> expression, EObject self) {
    EcoreEvaluationEnvironment values =
        new EcoreEvaluationEnvironment((EcoreEnvironmentFactory) environment.getFactory());
    values.add("self", self);
    return new Visitor(values, values.createExtentMap(self)).visitExpression(expression);
  }

  private final class Visitor extends EvaluationVisitorImpl {
    private final EcoreEvaluationEnvironment values;
    private final Map<EClass, Set<EObject>> extents;

    Visitor(EcoreEvaluationEnvironment values, Map<EClass, Set<EObject>> extents) {
      super(environment, values, extents);
      this.values = values;
      this.extents = extents;
    }

    /** As the original, which would have our environment make the nested one. */
    @Override
    protected Object call(
        EOperation operation, OCLExpression<EClassifier> body, Object target, Object[] args) {
      EcoreEvaluationEnvironment nested = new EcoreEvaluationEnvironment(values);
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
      EcoreEvaluationEnvironment nested = new EcoreEvaluationEnvironment(values);
      nested.add("self", target);
      return new Visitor(nested, extents).visitExpression(derivation);
    }
  }
}
