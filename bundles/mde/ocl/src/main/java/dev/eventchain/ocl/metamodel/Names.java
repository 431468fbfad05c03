package dev.eventchain.ocl.metamodel;

import java.util.List;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.ENamedElement;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** Names of elements of models and metamodels, and of values, in messages. */
public final class Names {

  private static final List<String> NAMING_FEATURES = List.of("name", "id", "label", "title");

  private Names() {}

  /** Returns the name of an element of a metamodel. */
  public static String of(Object element) {
    return element instanceof ENamedElement named ? named.getName() : String.valueOf(element);
  }

  /** Returns {@code package::Class}. */
  public static String qualified(EClassifier classifier) {
    EPackage owner = classifier.getEPackage();
    return (owner == null ? "" : PackageIndex.qualifiedName(owner) + "::") + of(classifier);
  }

  /** Returns a value, short, on one line, with quotes around a text. */
  public static String ofValue(Object value) {
    return ValueTexts.of(value);
  }

  /** Returns the class of an object and its name, or else its place in its model. */
  public static String label(EObject object) {
    String type = object.eClass().getName();
    String name = nameOf(object);
    return name.isEmpty()
        ? type + " " + pathOf(object)
        : type + " '" + ValueTexts.shortened(name) + "'";
  }

  private static String nameOf(EObject object) {
    EClass type = object.eClass();
    EAttribute id = type.getEIDAttribute();
    for (String featureName : NAMING_FEATURES) {
      String name = textOf(object, type.getEStructuralFeature(featureName));
      if (!name.isEmpty()) {
        return name;
      }
    }
    return textOf(object, id);
  }

  private static String textOf(EObject object, EStructuralFeature feature) {
    return feature instanceof EAttribute && object.eGet(feature) instanceof String text ? text : "";
  }

  /** Returns the path of an object from the root of its model, {@code /} for the root itself. */
  public static String pathOf(EObject object) {
    if (object.eContainer() == null) {
      return "/";
    }
    return object.eResource() == null
        ? EcoreUtil.getRelativeURIFragmentPath(EcoreUtil.getRootContainer(object), object)
        : object.eResource().getURIFragment(object);
  }
}
