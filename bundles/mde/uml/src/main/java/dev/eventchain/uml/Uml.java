package dev.eventchain.uml;

import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EAnnotation;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.ENamedElement;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.emf.ecore.util.ExtendedMetaData;

/**
 * The metamodel of UML 2.5, whose derived features and operations are those of Eclipse UML2, and
 * what comes with it. Its classes are loaded when a model or a template first names them.
 * Thread-safe.
 */
public final class Uml {

  private static final String ECLIPSE = "http://www.eclipse.org/uml2/";

  /** The namespace of the metamodel. */
  public static final String NAMESPACE = ECLIPSE + "5.0.0/UML";

  /** The class of the metamodel in Eclipse UML2. */
  private static final String PACKAGE = "org.eclipse.uml2.uml.internal.impl.UMLPackageImpl";

  /** The namespaces of UML by Eclipse UML2 (2.0.0 to 5.0.0) and by the OMG. */
  private static final Pattern METAMODEL =
      Pattern.compile(
          "http://www\\.eclipse\\.org/uml2/[2-5](\\.\\d+)*/UML"
              + "|http://(www|schema)\\.omg\\.org/spec/UML/(20\\d{6}|2(\\.\\d+)*)(/uml\\.xml)?");

  private static final Pattern OLDER =
      Pattern.compile("http://www\\.eclipse\\.org/uml2/([1-4](?:\\.\\d+)*)/UML");

  /** Elements in files of the OMG, such as {@code .../PrimitiveTypes.xmi#String}. */
  private static final Pattern OF_THE_OMG =
      Pattern.compile(
          "http://(?:www|schema)\\.omg\\.org/spec/(?:UML|PrimitiveTypes)/[^/#]+"
              + "/(PrimitiveTypes|uml|UML)\\.(?:xml|xmi)#(\\w+)");

  private static final Set<String> PRIMITIVE_TYPES =
      Set.of("Boolean", "Integer", "Real", "String", "UnlimitedNatural");

  private static final Pattern LIBRARIES =
      Pattern.compile("pathmap://UML_(LIBRARIES|METAMODELS|PROFILES)/\\w+\\.[a-z]+\\.uml");

  private static final String CLASSES = "pathmap://UML_METAMODELS/UML.metamodel.uml";

  private static final String LIBRARY = "pathmap://UML_LIBRARIES/UMLPrimitiveTypes.library.uml";

  /** The standard profile is one file again since UML 2.5. */
  private static final String OLD_PROFILES = "pathmap://UML_PROFILES/StandardL";

  private static final String STANDARD_PROFILE = "pathmap://UML_PROFILES/Standard.profile.uml";

  /** The namespaces of the standard profile. */
  private static final Pattern STANDARD =
      Pattern.compile(
          "http://www\\.eclipse\\.org/uml2/(\\d(\\.\\d+)*/UML/Profile/(Standard|L[23])|schemas/Standard/\\d+)");

  private Uml() {}

  /**
   * Returns what to do with a file of a version of Eclipse UML2 that called features and classes
   * otherwise: UML2 knows how to convert it, and this program does not.
   *
   * @return a hint; empty if the namespace is not that of UML, or of the current version
   */
  public static Optional<String> conversion(String nsUri) {
    Matcher version = OLDER.matcher(nsUri);
    return version.matches()
        ? Optional.of(
            "The file is of Eclipse UML2 %s, and UML 2.5 is read here: open and save it with Eclipse UML2 5, for example in Papyrus, which converts it."
                .formatted(version.group(1)))
        : Optional.empty();
  }

  /** Returns whether a namespace is that of UML, of any version 2. */
  public static boolean isNamespace(String nsUri) {
    return METAMODEL.matcher(nsUri).matches();
  }

  /**
   * Returns the metamodel of a namespace: UML itself, its data types, or one of the profiles that
   * come with it. All versions of UML have one metamodel, that of UML 2.5.
   *
   * @return empty if the namespace is of something else, or if Eclipse UML2 is not installed
   */
  public static Optional<EPackage> metamodel(String nsUri) {
    if (nsUri == null || !(nsUri.startsWith(ECLIPSE) || isNamespace(nsUri))) {
      return Optional.empty();
    }
    try {
      return STANDARD.matcher(nsUri).matches()
          ? UmlClasses.standardProfile()
          : UmlClasses.metamodel(nsUri, isNamespace(nsUri));
    } catch (LinkageError e) {
      return Optional.empty();
    }
  }

  /**
   * Returns the name of the feature that an XML element of UML's files stands for: the element
   * {@code node} of an activity is its {@code ownedNode}, while {@code node} is derived.
   */
  public static String featureOfElement(EClass type, String element) {
    boolean differs = element.equals("node") || element.equals("group");
    if (!differs || !isMetamodel(type.getEPackage())) {
      return element;
    }
    return type.getEAllStructuralFeatures().stream()
        .filter(feature -> element.equals(nameAsElement(feature)))
        .findFirst()
        .map(ENamedElement::getName)
        .orElse(element);
  }

  private static String nameAsElement(EStructuralFeature feature) {
    boolean element =
        "element".equals(EcoreUtil.getAnnotation(feature, ExtendedMetaData.ANNOTATION_URI, "kind"));
    return element
        ? EcoreUtil.getAnnotation(feature, ExtendedMetaData.ANNOTATION_URI, "name")
        : null;
  }

  /**
   * Returns a new element of the first class of UML that is not abstract and extends a class of it.
   *
   * @return empty if the class is not of UML
   */
  public static Optional<EObject> instanceOf(EClass type) {
    if (!isMetamodel(type.getEPackage())) {
      return Optional.empty();
    }
    return type.getEPackage().getEClassifiers().stream()
        .filter(EClass.class::isInstance)
        .map(EClass.class::cast)
        .filter(each -> !each.isAbstract() && !each.isInterface() && type.isSuperTypeOf(each))
        .findFirst()
        .map(EcoreUtil::create);
  }

  /** Returns whether a metamodel is UML itself, of Eclipse UML2. */
  public static boolean isMetamodel(EPackage metamodel) {
    // Asked for each reference of a model, so neither loads a class nor compares namespaces.
    return metamodel != null && metamodel.getClass().getName().equals(PACKAGE);
  }

  /**
   * Returns a reference to a primitive type or a metaclass in a file of the OMG, or to the standard
   * profile of an older version, as one to a file of Eclipse UML2 5.
   */
  public static String withKnownLibrary(String reference) {
    if (reference.startsWith(OLD_PROFILES)) {
      return STANDARD_PROFILE + reference.replaceFirst("^[^#]*", "");
    }
    Matcher element = OF_THE_OMG.matcher(reference);
    if (!element.matches()) {
      return reference;
    }
    String name = element.group(2);
    if (PRIMITIVE_TYPES.contains(name)) {
      return LIBRARY + "#" + name;
    }
    return element.group(1).equals("PrimitiveTypes") ? reference : CLASSES + "#" + name;
  }

  /** Returns whether a URI names a file that comes with UML2: {@code pathmap://UML_...}. */
  public static boolean isLibrary(URI file) {
    return LIBRARIES.matcher(file.toString()).matches();
  }

  /**
   * Returns a file that comes with UML2, such as {@code
   * pathmap://UML_LIBRARIES/UMLPrimitiveTypes.library.uml}. It is shared, and must not be changed.
   *
   * @return empty if there is no such file, or if Eclipse UML2 is not installed
   */
  public static Optional<Resource> library(URI file) {
    if (!isLibrary(file)) {
      return Optional.empty();
    }
    try {
      return UmlClasses.library(file);
    } catch (LinkageError e) {
      return Optional.empty();
    }
  }

  /** Returns whether an element is a profile of UML, which extends the metamodel. */
  public static boolean isProfile(EObject element) {
    return element != null
        && element.eClass().getName().equals("Profile")
        && isMetamodel(element.eClass().getEPackage());
  }

  /** Returns whether a package defines the stereotypes of a profile, as UML2 stores it there. */
  public static boolean isDefinition(EPackage definition) {
    EPackage top = definition;
    while (top.getESuperPackage() != null) {
      top = top.getESuperPackage();
    }
    return top.eContainer() instanceof EAnnotation annotation
        && isProfile(annotation.getEModelElement());
  }
}
