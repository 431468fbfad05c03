package dev.eventchain.metamodel;

import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;

/**
 * The Java classes that a metamodel names for its classes. EMF asks them what is an instance, so
 * that with one which is not there, or is another one, a class has no instances at all.
 */
final class JavaNames {

  private JavaNames() {}

  /** Takes the names from the classes of a package, but for those of map entries. */
  static void forget(EPackage ePackage) {
    for (EClassifier classifier : ePackage.getEClassifiers()) {
      if (classifier instanceof EClass type && !EcorePlan.isMapEntry(type)) {
        type.setInstanceClassName(null);
      }
    }
  }
}
