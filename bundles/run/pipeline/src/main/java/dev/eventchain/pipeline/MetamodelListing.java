package dev.eventchain.pipeline;

import java.util.List;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.ENamedElement;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.ETypedElement;

/**
 * The packages, classes, features and operations of metamodels as text: a line for each, in the
 * order of the file.
 */
final class MetamodelListing {

  private final StringBuilder text = new StringBuilder();

  private MetamodelListing() {}

  static String of(List<EPackage> metamodels) {
    MetamodelListing listing = new MetamodelListing();
    metamodels.forEach(each -> listing.add(each, ""));
    return listing.text.toString();
  }

  private void add(EPackage metamodel, String outer) {
    String name = outer + metamodel.getName();
    line("package " + name + " '" + metamodel.getNsURI() + "'");
    for (EClassifier each : metamodel.getEClassifiers()) {
      if (each instanceof EClass type) {
        add(type);
      } else if (each instanceof EEnum enumeration) {
        line("  enum " + each.getName() + ": " + literals(enumeration));
      } else {
        line(
            "  datatype "
                + each.getName()
                + " ("
                + ((EDataType) each).getInstanceClassName()
                + ")");
      }
    }
    metamodel.getESubpackages().forEach(each -> add(each, name + "::"));
  }

  private static String literals(EEnum enumeration) {
    return enumeration.getELiterals().stream()
        .map(each -> each.getName() + " = " + each.getValue())
        .collect(Collectors.joining(", "));
  }

  private void add(EClass type) {
    String kind =
        type.isInterface() ? "interface " : type.isAbstract() ? "abstract class " : "class ";
    String above = names(type.getESuperTypes());
    line("  " + kind + type.getName() + (above.isEmpty() ? "" : " extends " + above));
    type.getEStructuralFeatures().forEach(each -> line("    " + words(each)));
    type.getEOperations().forEach(each -> line("    " + words(each)));
  }

  private static String names(List<? extends ENamedElement> elements) {
    return elements.stream().map(ENamedElement::getName).collect(Collectors.joining(", "));
  }

  private static String words(EStructuralFeature feature) {
    StringBuilder words = new StringBuilder(feature.getName() + " : " + typeOf(feature));
    if (feature instanceof EReference reference) {
      words.append(reference.isContainment() ? ", contained" : "");
      words.append(
          reference.getEOpposite() == null
              ? ""
              : ", opposite of " + reference.getEOpposite().getName());
    }
    words.append(feature.isDerived() ? ", derived" : "");
    words.append(feature.isChangeable() ? "" : ", read-only");
    String value = feature.getDefaultValueLiteral();
    return words.append(value == null ? "" : ", default " + value).toString();
  }

  private static String words(EOperation operation) {
    String parameters =
        operation.getEParameters().stream()
            .map(each -> each.getName() + " : " + typeOf(each))
            .collect(Collectors.joining(", "));
    String result = operation.getEType() == null ? "" : " : " + typeOf(operation);
    return operation.getName() + "(" + parameters + ")" + result;
  }

  /** Returns the type with its multiplicity: {@code Node [0..*]}. */
  private static String typeOf(ETypedElement element) {
    String name = element.getEType() == null ? "?" : element.getEType().getName();
    int least = element.getLowerBound();
    int most = element.getUpperBound();
    String bounds = most < 0 ? least + "..*" : least == most ? "" + least : least + ".." + most;
    return name + " [" + bounds + "]";
  }

  private void line(String line) {
    text.append(line).append('\n');
  }
}
