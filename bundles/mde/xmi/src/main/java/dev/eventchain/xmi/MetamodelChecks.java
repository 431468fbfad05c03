package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Diagnostic;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Set;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.ENamedElement;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.EcorePackage;

/** Checks that a metamodel is sound enough for EMF to work with its models. */
final class MetamodelChecks {

  private final Origins origins;
  private final List<Diagnostic> found = new ArrayList<>();

  MetamodelChecks(Origins origins) {
    this.origins = origins;
  }

  /** Returns the findings about a package and its contents. */
  List<Diagnostic> check(EPackage root) {
    checkPackage(root);
    for (Iterator<EObject> all = root.eAllContents(); all.hasNext(); ) {
      EObject element = all.next();
      if (element instanceof EPackage inner) {
        checkPackage(inner);
      } else if (element instanceof EClassifier || element instanceof EStructuralFeature) {
        checkName((ENamedElement) element);
      }
      if (element instanceof EDataType type) {
        checkDataType(type);
      }
      if (element instanceof EClass eClass) {
        checkClass(eClass);
      } else if (element instanceof EAttribute attribute
          && attribute.getEType() instanceof EEnum type
          && type.getELiterals().isEmpty()) {
        report(attribute, "Enumeration `" + type.getName() + "` has no literal to be a value.");
      }
    }
    return found;
  }

  private void checkPackage(EPackage ePackage) {
    checkName(ePackage);
    String uri = ePackage.getNsURI();
    if (EcorePackage.eNS_URI.equals(uri)) {
      report(ePackage, "Package `" + ePackage.getName() + "` uses the nsURI of Ecore.");
    }
    checkUnique(ePackage.getEClassifiers(), "package `" + ePackage.getName() + "`");
  }

  private void checkClass(EClass eClass) {
    if (inheritsFromItself(eClass)) {
      report(eClass, "Class `" + eClass.getName() + "` inherits from itself.");
      return;
    }
    checkUnique(eClass.getEStructuralFeatures(), "class `" + eClass.getName() + "`");
    for (EStructuralFeature feature : eClass.getEStructuralFeatures()) {
      if (feature.getEType() == null) {
        report(feature, "Feature `" + feature.getName() + "` has no type.");
      } else if (feature instanceof EReference reference && reference.getEOpposite() != null) {
        checkOpposite(reference, reference.getEOpposite());
      }
    }
  }

  /** Checks an opposite; EMF's reader cannot represent pairs that only one end declares. */
  private void checkOpposite(EReference reference, EReference opposite) {
    EReference back = opposite.getEOpposite();
    if (back != reference) {
      found.add(
          Diagnostic.of(
                  XmiRules.METAMODEL_UNSOUND,
                  "%s names %s as its opposite, which names %s."
                      .formatted(
                          shown(reference), shown(opposite), back == null ? "none" : shown(back)),
                  origins.locate(reference))
              .withRelated(origins.locate(opposite))
              .withHint("Declare eOpposite at both ends, or at neither."));
    } else if (!opposite.getEContainingClass().isSuperTypeOf(reference.getEReferenceType())) {
      report(
          reference,
          "The opposite of %s is %s, which elements of `%s` do not have."
              .formatted(shown(reference), shown(opposite), reference.getEType().getName()));
    }
  }

  private static String shown(EReference reference) {
    return "`%s` of `%s`".formatted(reference.getName(), reference.getEContainingClass().getName());
  }

  private void checkDataType(EDataType type) {
    if (!HarmlessTypes.contains(type)) {
      refuseType(type, String.valueOf(type.getInstanceClassName()));
    }
  }

  private void refuseType(ENamedElement element, String javaClass) {
    found.add(
        Diagnostic.of(
                XmiRules.DATATYPE_REFUSED,
                "Values of `%s` would run code of a Java class: its base type is one of `%s`."
                    .formatted(element.getName(), javaClass),
                origins.locate(element))
            .withHint("Use another base type: a data type of Ecore or of XML Schema."));
  }

  private void checkName(ENamedElement element) {
    if (element.getName() == null || element.getName().isBlank()) {
      report(element, "The " + element.eClass().getName() + " has no name.");
    }
  }

  private void checkUnique(List<? extends ENamedElement> elements, String owner) {
    Set<String> names = new HashSet<>();
    for (ENamedElement element : elements) {
      if (element.getName() != null && !names.add(element.getName())) {
        report(element, "The name `" + element.getName() + "` appears twice in " + owner + ".");
      }
    }
  }

  /** Walks direct supertypes, as EMF's list of all supertypes is endless on a cycle. */
  private static boolean inheritsFromItself(EClass eClass) {
    Deque<EClass> open = new ArrayDeque<>(eClass.getESuperTypes());
    Set<EClass> seen = new HashSet<>();
    while (!open.isEmpty()) {
      EClass next = open.pop();
      if (next == eClass) {
        return true;
      }
      if (seen.add(next)) {
        open.addAll(next.getESuperTypes());
      }
    }
    return false;
  }

  private void report(EObject element, String message) {
    found.add(Diagnostic.of(XmiRules.METAMODEL_UNSOUND, message, origins.locate(element)));
  }
}
