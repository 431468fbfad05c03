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
 * The Java classes that a metamodel names. None is ever loaded: classes do without, and the values
 * of data types over classes that are not harmless are kept as the texts that they are.
 *
 * <p>EMF asks the Java class of a class what is an instance, so that with one which is not there,
 * or is another one, a class has no instances at all.
 */
final class JavaNames {

  private static final String TEXT = "java.lang.String";

  /** What takes the places of Ecore's own types whose values EMF loads or deserialises. */
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

  /** Takes the names out of a package and its subpackages, but for those of map entries. */
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
