package dev.eventchain.ocl;

import dev.eventchain.ocl.parse.OclEnvironment;
import dev.eventchain.ocl.tree.BigLiterals;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.eclipse.emf.common.util.TreeIterator;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.ocl.ecore.IfExp;
import org.eclipse.ocl.ecore.IntegerLiteralExp;
import org.eclipse.ocl.ecore.OperationCallExp;
import org.eclipse.ocl.ecore.PropertyCallExp;
import org.eclipse.ocl.ecore.RealLiteralExp;
import org.eclipse.ocl.ecore.StringLiteralExp;
import org.eclipse.ocl.expressions.LoopExp;
import org.eclipse.ocl.expressions.OCLExpression;

/** Finds the features that an expression reads and the literals in it, also through definitions. */
final class Navigations {

  /** Operations of Booleans, with which a part of a condition may not matter. */
  private static final Set<String> CONNECTIVES = Set.of("and", "or", "xor", "not", "implies");

  private final OclEnvironment environment;
  private final Set<Expression.Navigation> found = new LinkedHashSet<>();
  private final Set<Object> literals = new LinkedHashSet<>();
  private boolean conditional;
  private final Set<OCLExpression<EClassifier>> visited = new HashSet<>();

  private Navigations(OclEnvironment environment) {
    this.environment = environment;
  }

  static List<Expression.Navigation> of(EObject expression, OclEnvironment environment) {
    Navigations navigations = new Navigations(environment);
    navigations.walk(expression);
    return new ArrayList<>(navigations.found);
  }

  static boolean isConditional(EObject expression, OclEnvironment environment) {
    Navigations navigations = new Navigations(environment);
    navigations.walk(expression);
    return navigations.conditional;
  }

  static Set<Object> literals(EObject expression, OclEnvironment environment) {
    Navigations navigations = new Navigations(environment);
    navigations.walk(expression);
    return navigations.literals;
  }

  /** Returns the defined operations and properties that an expression uses directly. */
  static Set<Object> definitionsIn(EObject expression, OclEnvironment environment) {
    Set<Object> definitions = new LinkedHashSet<>();
    TreeIterator<EObject> nodes = EcoreUtil.getAllContents(List.of(expression));
    while (nodes.hasNext()) {
      EObject node = nodes.next();
      Object feature =
          node instanceof PropertyCallExp property
              ? property.getReferredProperty()
              : node instanceof OperationCallExp call ? call.getReferredOperation() : null;
      if (feature != null && environment.getDefinition(feature) != null) {
        definitions.add(feature);
      }
    }
    return definitions;
  }

  private void walk(EObject expression) {
    TreeIterator<EObject> nodes = EcoreUtil.getAllContents(List.of(expression));
    while (nodes.hasNext()) {
      EObject node = nodes.next();
      conditional |= node instanceof IfExp || node instanceof LoopExp<?, ?> || isConnective(node);
      if (node instanceof PropertyCallExp call) {
        EStructuralFeature feature = call.getReferredProperty();
        if (!followed(environment.bodyOf(feature)) && feature.getEContainingClass() != null) {
          EClass owner =
              call.getSource().getType() instanceof EClass type
                  ? type
                  : feature.getEContainingClass();
          found.add(new Expression.Navigation(owner, feature));
        }
      } else if (node instanceof OperationCallExp call && call.getReferredOperation() != null) {
        followed(environment.bodyOf(call.getReferredOperation()));
      } else {
        addLiteral(node);
      }
    }
  }

  private static boolean isConnective(EObject node) {
    return node instanceof OperationCallExp call
        && call.getReferredOperation() != null
        && CONNECTIVES.contains(call.getReferredOperation().getName());
  }

  private void addLiteral(EObject node) {
    if (node instanceof StringLiteralExp text) {
      literals.add(text.getStringSymbol());
    } else if (node instanceof RealLiteralExp real) {
      literals.add(real.getRealSymbol());
    } else if (node instanceof IntegerLiteralExp integer) {
      literals.add(BigLiterals.valueOf(integer));
    }
  }

  /** Walks the body of a definition; returns whether there is one. */
  private boolean followed(OCLExpression<EClassifier> body) {
    if (body != null && visited.add(body)) {
      walk((EObject) body);
    }
    return body != null;
  }
}
