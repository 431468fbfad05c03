package dev.eventchain.xmi;

import org.eclipse.emf.common.util.TreeIterator;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.EcorePackage;

/**
 * Removes the Java classes that a metamodel names, so that none is ever loaded. Values of data
 * types whose Java classes are not harmless stay texts.
 *
 * <p>EMF uses the Java class of an EClass to decide what is an instance; if it is missing or
 * different, the EClass has no instances.
 */
final class JavaNames {

  private static final String TEXT = "java.lang.String";

  /** The replacement of Ecore's own types whose values EMF loads or deserialises. */
  private static final EDataType OBJECT = opaque(EcorePackage.Literals.EJAVA_OBJECT);

  private static final EDataType CLASS = opaque(EcorePackage.Literals.EJAVA_CLASS);

  private JavaNames() {}

  private static EDataType opaque(EDataType original) {
    EDataType type = EcoreFactory.eINSTANCE.createEDataType();
    type.setName(original.getName());
    type.setInstanceClassName(TEXT);
    EPackage home = EcoreFactory.eINSTANCE.createEPackage();
    home.setName("java");
    home.setNsURI("http://eventchain.dev/java/" + original.getName());
    home.getEClassifiers().add(type);
    return type;
  }

  /** Removes the names from a package and its subpackages, except for those of map entries. */
  static void forget(EPackage ePackage) {
    for (TreeIterator<EObject> all = ePackage.eAllContents(); all.hasNext(); ) {
      EObject element = all.next();
      if (element instanceof EClassifier classifier) {
        forget(classifier);
      } else if (element instanceof EStructuralFeature feature) {
        if (feature.getEType() == EcorePackage.Literals.EJAVA_OBJECT) {
          feature.setEType(OBJECT);
        } else if (feature.getEType() == EcorePackage.Literals.EJAVA_CLASS) {
          feature.setEType(CLASS);
        }
      }
    }
  }

  private static void forget(EClassifier classifier) {
    if (classifier instanceof EClass type) {
      if (!EcorePlan.isMapEntry(type)) {
        type.setInstanceClassName(null);
      }
    } else if (!(classifier instanceof EEnum) && !HarmlessTypes.isHarmlessClass(classifier)) {
      classifier.setInstanceClassName(TEXT);
    }
  }
}
