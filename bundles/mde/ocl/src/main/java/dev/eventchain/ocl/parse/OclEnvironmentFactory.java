package dev.eventchain.ocl.parse;

import dev.eventchain.ocl.dialect.Dialect;
import dev.eventchain.ocl.metamodel.PackageIndex;
import java.util.HashSet;
import java.util.Set;
import java.util.function.Function;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.ocl.Environment;
import org.eclipse.ocl.ecore.CallOperationAction;
import org.eclipse.ocl.ecore.Constraint;
import org.eclipse.ocl.ecore.EcoreEnvironmentFactory;
import org.eclipse.ocl.ecore.SendSignalAction;
import org.eclipse.ocl.expressions.OCLExpression;

/** Makes Eclipse OCL use our environments, analyzer and evaluator. */
public final class OclEnvironmentFactory extends EcoreEnvironmentFactory {

  private final PackageIndex packages;
  private final Dialect dialect;
  private final Libraries libraries;
  private final OclEnvironment root;
  private final ProblemTexts texts;
  private final Set<String> failedNames = new HashSet<>();
  private final Set<Object> statics = new HashSet<>();
  private boolean declaring;
  private Function<ETypedElement, OCLExpression<EClassifier>> bodies = element -> null;

  public OclEnvironmentFactory(PackageIndex packages, Dialect dialect) {
    super(packages.registry());
    this.packages = packages;
    this.dialect = dialect;
    this.libraries = new Libraries(dialect);
    this.root = new OclEnvironment(this);
    this.texts = new ProblemTexts(root, packages);
  }

  /** Marks the start or end of a declaration, which may override operations of superclasses. */
  public void declare(boolean begins) {
    declaring = begins;
  }

  boolean isDeclaring() {
    return declaring;
  }

  /** Sets the source of the bodies of features and operations. */
  public void computeBy(Function<ETypedElement, OCLExpression<EClassifier>> source) {
    bodies = source;
  }

  /** Returns the body of a feature or an operation; null if there is none. */
  OCLExpression<EClassifier> bodyOf(ETypedElement element) {
    return bodies.apply(element);
  }

  public PackageIndex packages() {
    return packages;
  }

  Dialect dialect() {
    return dialect;
  }

  public Libraries libraries() {
    return libraries;
  }

  public OclEnvironment root() {
    return root;
  }

  ProblemTexts texts() {
    return texts;
  }

  /** Returns the static definitions. */
  Set<Object> statics() {
    return statics;
  }

  Set<String> failedNames() {
    return failedNames;
  }

  @Override
  public OclEnvironment createEnvironment() {
    return new OclEnvironment(this);
  }

  @Override
  public OclEnvironment createEnvironment(
      Environment<
              EPackage,
              EClassifier,
              EOperation,
              EStructuralFeature,
              EEnumLiteral,
              EParameter,
              EObject,
              CallOperationAction,
              SendSignalAction,
              Constraint,
              EClass,
              EObject>
          parent) {
    return new OclEnvironment((OclEnvironment) parent);
  }

  @Override
  public OclAnalyzer createOCLAnalyzer(
      Environment<
              EPackage,
              EClassifier,
              EOperation,
              EStructuralFeature,
              EEnumLiteral,
              EParameter,
              EObject,
              CallOperationAction,
              SendSignalAction,
              Constraint,
              EClass,
              EObject>
          environment,
      String input) {
    return new OclAnalyzer((OclEnvironment) environment, input);
  }
}
