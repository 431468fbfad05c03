package dev.eventchain.ocl.metamodel;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.eclipse.emf.ecore.EAnnotation;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EModelElement;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.impl.EPackageImpl;
import org.eclipse.emf.ecore.util.ExtendedMetaData;

/**
 * The OCL that an Ecore metamodel holds in annotations, as OCLinEcore and EMF's delegates write it
 * ("OCLinEcore", "Delegates" in the documentation of Eclipse OCL).
 */
public final class OclAnnotations {

  private static final String ECORE = EcorePackage.eNS_URI;

  /** The sources of annotations with expressions, including those of the Pivot dialect. */
  private static final List<String> SOURCES =
      List.of(
          ECORE + "/OCL",
          ECORE + "/OCL/Pivot",
          ECORE + "/OCL/LPG",
          ECORE + "/OCL/debug",
          "http://www.eclipse.org/ocl/examples/OCL");

  private static final Pattern NAMES_OCL = Pattern.compile("(?i).*\\bocl\\b.*");

  /** The suffix of the key of an invariant's message. */
  private static final String MESSAGE = "$message";

  /**
   * A text of an annotation.
   *
   * @param entry the detail with the text
   */
  public record Text(String key, String value, EObject entry) {}

  private OclAnnotations() {}

  /** Returns whether annotations of a source hold OCL. */
  public static boolean isSource(String source) {
    return SOURCES.contains(source);
  }

  /** Returns the invariants of a class or a data type by name. */
  public static Map<String, Text> invariants(EClassifier type) {
    Map<String, Text> invariants = details(type);
    invariants.keySet().removeIf(key -> key.endsWith(MESSAGE));
    return invariants;
  }

  /** Returns the expression for the message of an invariant. */
  public static Optional<Text> message(EClassifier type, String invariant) {
    return Optional.ofNullable(details(type).get(invariant + MESSAGE));
  }

  /** Returns the body of a feature or an operation. */
  public static Optional<Text> body(ETypedElement element) {
    return Optional.ofNullable(details(element).get(bodyKey(element)));
  }

  private static String bodyKey(ETypedElement element) {
    return element instanceof EOperation ? "body" : "derivation";
  }

  /** Returns the pre- and postconditions of an operation, or the initial value of a feature. */
  public static List<Text> conditions(ETypedElement element) {
    return details(element).values().stream().filter(each -> isCondition(element, each)).toList();
  }

  private static boolean isCondition(ETypedElement element, Text text) {
    return element instanceof EOperation
        ? text.key().startsWith("pre") || text.key().startsWith("post")
        : text.key().equals("initial");
  }

  /** Returns the texts of an operation or a feature that have no meaning there. */
  public static List<Text> misunderstood(ETypedElement element) {
    return details(element).values().stream()
        .filter(each -> !each.key().equals(bodyKey(element)) && !isCondition(element, each))
        .toList();
  }

  /** Returns the declared constraints of a classifier without OCL, which Java code checks. */
  public static Set<String> constraintsInJava(EClassifier type) {
    Set<String> inJava = new LinkedHashSet<>();
    for (Text text : texts(type, ECORE)) {
      if (text.key().equals("constraints") && !text.value().isBlank()) {
        inJava.addAll(List.of(text.value().strip().split("\\s+", -1)));
      }
    }
    inJava.removeAll(invariants(type).keySet());
    return inJava;
  }

  /** Returns whether a feature stores no value; features of a feature map's entries do. */
  public static boolean isComputed(EStructuralFeature feature) {
    return (feature.isVolatile() || (feature.isDerived() && feature.isTransient()))
        && ExtendedMetaData.INSTANCE.getGroup(feature) == null
        && ExtendedMetaData.INSTANCE.getFeatureKind(feature)
            == ExtendedMetaData.UNSPECIFIED_FEATURE;
  }

  /**
   * Returns whether a feature of a metamodel without generated code is computed, but has no body:
   * reading it gives its default.
   */
  public static boolean isComputedInJava(EStructuralFeature feature) {
    EClass owner = feature.getEContainingClass();
    EPackage ePackage = owner == null ? null : owner.getEPackage();
    return isComputed(feature)
        && ePackage != null
        && ePackage.getClass() == EPackageImpl.class
        && body(feature).isEmpty();
  }

  /** Returns the texts of the annotations of an element by key; the first of several per key. */
  static Map<String, Text> details(EModelElement element) {
    Map<String, Text> details = new LinkedHashMap<>();
    for (String source : SOURCES) {
      texts(element, source).forEach(text -> details.putIfAbsent(text.key(), text));
    }
    return details;
  }

  /** Returns annotations whose sources suggest OCL but that are not read. */
  public static List<EAnnotation> unknown(EModelElement element) {
    return element.getEAnnotations().stream()
        .filter(each -> each.getSource() != null && !SOURCES.contains(each.getSource()))
        .filter(each -> NAMES_OCL.matcher(each.getSource()).matches())
        .filter(each -> !each.getDetails().isEmpty())
        .toList();
  }

  /** Returns texts that differ from another one of the same key and source. */
  public static List<Text> contradictions(EModelElement element) {
    List<Text> contradictions = new ArrayList<>();
    for (String source : SOURCES) {
      Map<String, Text> known = new HashMap<>();
      for (Text text : texts(element, source)) {
        Text first = known.putIfAbsent(text.key(), text);
        if (first != null && !first.value().equals(text.value())) {
          contradictions.add(text);
        }
      }
    }
    return contradictions;
  }

  /** Returns the texts of all annotations of a source, of which Ecore allows several. */
  private static List<Text> texts(EModelElement element, String source) {
    List<Text> texts = new ArrayList<>();
    for (EAnnotation annotation : element.getEAnnotations()) {
      if (source.equals(annotation.getSource())) {
        for (Map.Entry<String, String> entry : annotation.getDetails()) {
          String value = entry.getValue() == null ? "" : entry.getValue();
          texts.add(new Text(entry.getKey(), value, (EObject) entry));
        }
      }
    }
    return texts;
  }
}
