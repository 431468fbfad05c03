package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.uml.Uml;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.xmi.ClassNotFoundException;
import org.eclipse.emf.ecore.xmi.FeatureNotFoundException;
import org.eclipse.emf.ecore.xmi.IllegalValueException;
import org.eclipse.emf.ecore.xmi.PackageNotFoundException;
import org.eclipse.emf.ecore.xmi.UnresolvedReferenceException;
import org.eclipse.emf.ecore.xmi.XMIException;
import org.xml.sax.SAXParseException;

/** Converts EMF's problems with one XMI file into findings that point to the text. */
final class XmiProblems {

  private static final Pattern NAMESPACE = Pattern.compile("xmlns:[\\w.-]+=\"([^\"]*)\"");

  /** The number of namespaces, from the beginning of a file, among which that of UML is. */
  private static final int NAMESPACES = 50;

  private final SourceText text;
  private final EPackage.Registry registry;
  private final Function<String, Optional<String>> profiles;
  private final List<Diagnostic> found = new ArrayList<>();

  /**
   * Creates an empty list of findings about a text.
   *
   * @param profiles returns a hint for a namespace that the file itself says the place of
   */
  XmiProblems(
      SourceText text, EPackage.Registry registry, Function<String, Optional<String>> profiles) {
    this.text = text;
    this.registry = registry;
    this.profiles = profiles;
  }

  List<Diagnostic> found() {
    return found;
  }

  SourceText text() {
    return text;
  }

  void add(Rule rule, String message, int offset, String hint) {
    found.add(Diagnostic.of(rule, message, text.at(offset)).withHint(hint));
  }

  /** Adds a problem that EMF reports for the element whose start tag is at an offset. */
  void add(XMIException problem, int tag) {
    if (problem instanceof FeatureNotFoundException feature) {
      addUnknownFeature(feature, tag);
    } else if (problem instanceof ClassNotFoundException type) {
      addUnknownClass(type, tag);
    } else if (problem instanceof PackageNotFoundException missing) {
      addUnknownPackage(missing, tag);
    } else if (problem instanceof IllegalValueException value) {
      addIllegalValue(value, tag);
    } else if (problem instanceof UnresolvedReferenceException reference) {
      add(
          XmiRules.REFERENCE_UNRESOLVED,
          "`" + reference.getReference() + "` names no element of this file.",
          valueIn(attributeIn(tag, reference.getFeature().getName()), reference.getReference()),
          "");
    } else {
      add(XmiRules.SYNTAX, message(problem), tag, "");
    }
  }

  /** Adds the exception that stopped the parser. */
  void add(IOException stopped) {
    if (!(stopped.getCause() instanceof SAXParseException syntax)) {
      add(XmiRules.SYNTAX, "The file is not valid XMI: " + stopped.getMessage(), 0, "");
      return;
    }
    int end = text.offset(syntax.getLineNumber(), syntax.getColumnNumber());
    int doctype = text.text().indexOf("<!DOCTYPE");
    if (doctype >= 0 && doctype <= end) {
      add(
          XmiRules.DOCTYPE,
          "The file has a document type declaration, which could pull in other files.",
          doctype,
          "Remove the declaration and write the text in place of its entities.");
    } else {
      add(XmiRules.SYNTAX, String.valueOf(syntax.getMessage()), end, "");
    }
  }

  /** Returns the offset of the {@code <} of the tag that ends at a position. */
  int tagEndingAt(int line, int column) {
    int end = text.offset(Math.max(1, line), Math.max(1, column));
    return Math.max(0, text.text().lastIndexOf('<', Math.max(0, end - 1)));
  }

  /** Adds that the type of a feature must not be created from text. */
  void refuseType(EStructuralFeature feature, int tag) {
    add(
        XmiRules.DATATYPE_REFUSED,
        "Values of `%s` would run code of the Java class `%s`."
            .formatted(feature.getName(), ((EDataType) feature.getEType()).getInstanceClassName()),
        attributeIn(tag, feature.getName()),
        "Leave the feature out.");
  }

  /** Adds that a text is not a finite number. */
  void refuseNumber(EStructuralFeature feature, String value, int tag) {
    add(
        XmiRules.NUMBER_NONFINITE,
        "`%s` is not a finite number, which feature `%s` needs."
            .formatted(value, feature.getName()),
        attributeIn(tag, feature.getName()),
        "Write a number, or leave the feature out.");
  }

  /** Adds that a file sets a computed feature. */
  void refuseComputed(EStructuralFeature feature, int tag) {
    add(
        XmiRules.FEATURE_COMPUTED,
        "Feature `%s` is volatile: its value is computed and cannot be set."
            .formatted(feature.getName()),
        attributeIn(tag, feature.getName()),
        "Leave it out, or declare the feature with volatile=\"false\".");
  }

  /** Adds that the element at an offset sets a single-valued feature again. */
  void addSecondValue(EStructuralFeature feature, int tag) {
    add(
        XmiRules.VALUE_TWICE,
        "Feature `%s` holds one value, but the file gives it another one here."
            .formatted(feature.getName()),
        attributeIn(tag, feature.getName()),
        "Keep one of them, or declare the feature with upperBound=\"-1\".");
  }

  /** Returns the finding that two elements have the same id; the model can still be checked. */
  Diagnostic duplicate(String id, int tag, int first) {
    return Diagnostic.of(
            XmiRules.ID_DUPLICATE,
            "The id `" + id + "` belongs to two elements.",
            text.at(valueIn(tag, "\"" + id + "\"")))
        .withRelated(text.at(first))
        .withHint("Give one of them another id: references could mean either.");
  }

  /** Adds that a reference would make an element contain itself. */
  void addCircle(int offset) {
    add(
        XmiRules.CONTAINMENT_CIRCLE,
        "With this reference an element would contain itself.",
        offset,
        "Remove the reference.");
  }

  private void addUnknownFeature(FeatureNotFoundException problem, int tag) {
    if (problem.getObject() == null) {
      add(XmiRules.FEATURE_UNKNOWN, "There is an element where only text is allowed.", tag, "");
      return;
    }
    EClass type = problem.getObject().eClass();
    List<String> known = type.getEAllStructuralFeatures().stream().map(f -> f.getName()).toList();
    add(
        XmiRules.FEATURE_UNKNOWN,
        "Class `" + type.getName() + "` has no feature `" + problem.getName() + "`.",
        attributeIn(tag, problem.getName()),
        withConversion(NearestName.hint(problem.getName(), known), type.getEPackage()));
  }

  /** Returns a hint about a name, and if it is one of UML, what to do with an older model. */
  private String withConversion(String hint, EPackage owner) {
    Optional<String> conversion =
        Uml.isMetamodel(owner)
            ? NAMESPACE
                .matcher(text.text())
                .results()
                .limit(NAMESPACES)
                .map(it -> Uml.conversion(it.group(1)))
                .flatMap(Optional::stream)
                .findFirst()
            : Optional.empty();
    return (hint + " " + conversion.orElse("")).strip();
  }

  private void addUnknownClass(ClassNotFoundException problem, int tag) {
    if (problem.getFactory() == null) {
      return; // The missing package is reported already.
    }
    EPackage ePackage = problem.getFactory().getEPackage();
    String name = "`" + problem.getName() + "`";
    int place = attributeIn(tag, "type");
    List<EClass> meant =
        ePackage == registry.getEPackage(Namespaces.NONE)
            ? Namespaces.withoutNamespace(problem.getName(), registry)
            : List.of();
    boolean isAbstract = meant.size() == 1 && meant.get(0).isAbstract();
    if (meant.size() > 1) {
      addAmbiguousClass(name, meant, place);
    } else if (isAbstract || ePackage.getEClassifier(problem.getName()) instanceof EClass) {
      add(
          XmiRules.CLASS_ABSTRACT,
          "Class " + name + " is abstract.",
          place,
          "Use a concrete class.");
    } else {
      add(
          XmiRules.CLASS_UNKNOWN,
          "Metamodel `" + ePackage.getName() + "` has no class " + name + ".",
          place,
          withConversion(NearestName.hint(problem.getName(), concreteClasses(ePackage)), ePackage));
    }
  }

  private static List<String> concreteClasses(EPackage ePackage) {
    return ePackage.getEClassifiers().stream()
        .filter(c -> c instanceof EClass eClass && !eClass.isAbstract())
        .map(EClassifier::getName)
        .toList();
  }

  private void addAmbiguousClass(String name, List<EClass> meant, int place) {
    List<String> owners = meant.stream().map(each -> each.getEPackage().getNsURI()).toList();
    add(
        XmiRules.CLASS_UNKNOWN,
        "Several packages without nsURI have a class " + name + ".",
        place,
        "Write its namespace: one of `%s`.".formatted(String.join("`, `", owners)));
  }

  private void addUnknownPackage(PackageNotFoundException problem, int tag) {
    if (problem.uri() == null || problem.uri().isEmpty()) {
      add(XmiRules.PACKAGE_UNKNOWN, "The element belongs to no namespace.", tag, "");
      return;
    }
    add(
        XmiRules.PACKAGE_UNKNOWN,
        "No metamodel with the namespace `" + problem.uri() + "` is loaded.",
        tag,
        profiles
            .apply(problem.uri())
            .orElseGet(() -> Namespaces.hint(problem.uri(), registry.keySet())));
  }

  private void addIllegalValue(IllegalValueException problem, int tag) {
    EStructuralFeature feature = problem.getFeature();
    Object value = problem.getValue();
    String shown =
        value instanceof EObject object ? "A " + object.eClass().getName() : "`" + value + "`";
    String type = feature.getEType().getName();
    List<String> literals =
        feature.getEType() instanceof EEnum eEnum
            ? eEnum.getELiterals().stream().map(EEnumLiteral::getLiteral).toList()
            : List.of();
    add(
        XmiRules.VALUE_ILLEGAL,
        shown
            + " is not a valid value for feature `"
            + feature.getName()
            + "` of type `"
            + type
            + "`.",
        attributeIn(tag, feature.getName()),
        NearestName.hint(String.valueOf(value), literals));
  }

  /** Returns the offset of an attribute, prefixed or not, in a tag; else that of the tag. */
  int attributeIn(int tag, String name) {
    int end = text.text().indexOf('>', tag);
    Matcher attribute =
        Pattern.compile("\\s(?:[\\w.-]+:)?" + Pattern.quote(name) + "\\s*=")
            .matcher(text.text())
            .region(tag, end < 0 ? text.text().length() : end);
    return attribute.find() ? attribute.start() + 1 : tag;
  }

  /** Returns the offset of a value in or after the tag at an offset; else that offset. */
  int valueIn(int tag, String value) {
    int end = text.text().indexOf('>', tag);
    // Unlimited, the search would scan the rest of the file for each reference.
    int last = (end < 0 ? text.text().length() : end) - value.length();
    for (int found = tag; found <= last; found++) {
      if (text.text().startsWith(value, found)) {
        return found;
      }
    }
    return tag;
  }

  /** Returns the message of the cause, without the position that EMF appends. */
  private static String message(XMIException problem) {
    Throwable cause = problem.getCause();
    String message = cause == null ? problem.getMessage() : cause.getMessage();
    return message == null ? String.valueOf(cause) : message;
  }
}
