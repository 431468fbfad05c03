package dev.eventchain.ocl;

import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.Environment;
import org.eclipse.ocl.cst.ClassifierContextDeclCS;
import org.eclipse.ocl.ecore.CallOperationAction;
import org.eclipse.ocl.ecore.Constraint;
import org.eclipse.ocl.ecore.SendSignalAction;
import org.eclipse.ocl.ecore.parser.OCLAnalyzer;

/** Turns text into a checked expression. */
final class OclAnalyzer extends OCLAnalyzer {

  OclAnalyzer(OclEnvironment environment, String input) {
    super(environment, input);
  }

  /** Our environments have their {@code self} already, or are meant to have none. */
  @Override
  protected Environment<
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
      createClassifierContext(
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
          ClassifierContextDeclCS context,
          EClassifier classifier) {
    return environment;
  }
}
