package dev.eventchain.agents.prompt;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EModelElement;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * A metamodel as text for a language model: a line for each class and each feature, about a quarter
 * as long as its Ecore file. Classes come in the order in which they can be reached from the root.
 */
public final class MetamodelText {
  private final Predicate<EStructuralFeature> wanted;
  private final Set<EClassifier> reached = new LinkedHashSet<>();
  private final List<String> lines = new ArrayList<>();

  private MetamodelText(Predicate<EStructuralFeature> wanted) {
    this.wanted = wanted;
  }

  /**
   * Returns the text of what can be reached from a class.
   *
   * @param root the name of the class
   * @param wanted true for the features that an answer may use
   */
  public static String of(EPackage metamodel, String root, Predicate<EStructuralFeature> wanted) {
    MetamodelText text = new MetamodelText(wanted);
    text.reach((EClass) metamodel.getEClassifier(root));
    text.reached.forEach(text::add);
    return String.join("\n", text.lines);
  }

  private void reach(EClass root) {
    Deque<EClassifier> open = new ArrayDeque<>(List.of(root));
    while (!open.isEmpty()) {
      EClassifier next = open.remove();
      if (reached.add(next) && next instanceof EClass type) {
        open.addAll(type.getESuperTypes());
        features(type)
            .map(EStructuralFeature::getEType)
            .filter(it -> isOwn(it, root))
            .forEach(open::add);
      }
    }
  }

  private Stream<EStructuralFeature> features(EClass type) {
    return type.getEStructuralFeatures().stream().filter(wanted);
  }

  private static boolean isOwn(EClassifier type, EClass root) {
    return type != null && type.getEPackage() == root.getEPackage();
  }

  private void add(EClassifier type) {
    if (type instanceof EEnum enumeration) {
      String literals =
          enumeration.getELiterals().stream()
              .map(each -> each.getLiteral() + documented(each, " (", ")"))
              .collect(Collectors.joining(", "));
      lines.add("enum " + type.getName() + ": " + literals + documented(type, " -- ", ""));
    } else if (type instanceof EClass found) {
      String above =
          found.getESuperTypes().stream().map(EClass::getName).collect(Collectors.joining(", "));
      lines.add(
          (found.isAbstract() ? "abstract class " : "class ")
              + found.getName()
              + (above.isEmpty() ? "" : " extends " + above)
              + documented(found, " -- ", ""));
      features(found).map(MetamodelText::text).forEach(lines::add);
    }
  }

  private static String text(EStructuralFeature feature) {
    boolean contains = feature instanceof EReference reference && reference.isContainment();
    return "  %s: %s%s%s%s"
        .formatted(
            feature.getName(),
            contains ? "contains " : "",
            typeOf(feature),
            feature.isMany() ? " [*]" : feature.isRequired() ? " [1]" : "",
            documented(feature, " -- ", ""));
  }

  private static String typeOf(EStructuralFeature feature) {
    String name = feature.getEType().getName();
    return switch (name) {
      case "EString" -> "String";
      case "EDouble" -> "Real";
      case "EInt", "ELong" -> "Integer";
      case "EBoolean" -> "Boolean";
      default -> name;
    };
  }

  private static String documented(EModelElement element, String before, String after) {
    String text = EcoreUtil.getDocumentation(element);
    return text == null ? "" : before + text + after;
  }
}
