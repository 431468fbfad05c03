package dev.eventchain.jsonmodels;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.Document;
import dev.eventchain.xmi.Origins;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * First step of the instance modeler: an object for each JSON object, with its attributes and the
 * objects nested in it. References by id are collected for the second step.
 */
final class InstanceObjects {

  static final String CLASS = "eClass";
  static final String ID = "id";

  /** An id in a reference. */
  record Link(EObject source, EReference reference, String id, String pointer) {}

  private final Document text;
  private final ClassIndex classes;
  private final Origins origins;
  private final List<Diagnostic> findings;
  private final AttributeValues attributes;
  private final List<EObject> all = new ArrayList<>();
  private final Map<String, EObject> byId = new LinkedHashMap<>();
  private final List<Link> links = new ArrayList<>();
  private final Map<EObject, String> pointers = new HashMap<>();
  private final Map<EObject, Set<EStructuralFeature>> given = new HashMap<>();

  InstanceObjects(Document text, ClassIndex classes, Origins origins, List<Diagnostic> findings) {
    this.text = text;
    this.classes = classes;
    this.origins = origins;
    this.findings = findings;
    this.attributes = new AttributeValues(text, findings);
  }

  /** Returns all objects in the order of the text. */
  List<EObject> all() {
    return all;
  }

  Map<String, EObject> byId() {
    return byId;
  }

  List<Link> links() {
    return links;
  }

  /** Returns whether the text states a feature of an object, validly or not. */
  boolean isGiven(EObject object, EStructuralFeature feature) {
    return given.getOrDefault(object, Set.of()).contains(feature);
  }

  /** Returns the place of a feature, or of its object if the text lacks the feature. */
  SourceLocation placeOf(EObject object, EStructuralFeature feature) {
    String pointer = pointers.get(object);
    return text.at(isGiven(object, feature) ? Document.below(pointer, feature.getName()) : pointer);
  }

  void read() {
    JsonNode root = text.root();
    if (root.isArray()) {
      readArray(root, "", null);
    } else if (root.isObject() && !root.has(CLASS) && isArrayForEachClass(root)) {
      root.fieldNames().forEachRemaining(name -> readClass(root, name));
    } else if (root.isObject()) {
      readObject(root, "", null);
    } else {
      type("The document must be an object or an array of objects", root, "");
    }
  }

  private static boolean isArrayForEachClass(JsonNode root) {
    for (JsonNode value : root) {
      if (!value.isArray()) {
        return false;
      }
    }
    return !root.isEmpty();
  }

  private void readClass(JsonNode root, String name) {
    Optional<EClass> implied = classNamed(name, Document.below("", name));
    implied.ifPresent(eClass -> readArray(root.get(name), Document.below("", name), eClass));
  }

  private void readArray(JsonNode array, String pointer, EClass implied) {
    for (int i = 0; i < array.size(); i++) {
      readObject(array.get(i), Document.below(pointer, i), implied);
    }
  }

  /** Reads an object; empty, with a finding, if its class is unknown. */
  private Optional<EObject> readObject(JsonNode json, String pointer, EClass implied) {
    if (!json.isObject()) {
      type("This must be an object", json, pointer);
      return Optional.empty();
    }
    Optional<EClass> eClass = classOf(json, pointer, implied);
    if (eClass.isEmpty()) {
      return Optional.empty();
    }
    EObject object = eClass.get().getEPackage().getEFactoryInstance().create(eClass.get());
    all.add(object);
    pointers.put(object, pointer);
    origins.put(object, text.at(pointer));
    noteId(json, pointer, object);
    json.fieldNames().forEachRemaining(name -> readFeature(object, name, json.get(name), pointer));
    return Optional.of(object);
  }

  private Optional<EClass> classOf(JsonNode json, String pointer, EClass implied) {
    JsonNode name = json.get(CLASS);
    if (name != null && name.isTextual()) {
      return classNamed(name.asText(), Document.below(pointer, CLASS));
    }
    if (name != null && !name.isNull()) {
      type("'eClass' must be the name of a class", name, Document.below(pointer, CLASS));
      return Optional.empty();
    }
    if (implied != null && !implied.isAbstract()) {
      return Optional.of(implied);
    }
    find(
        InstanceRules.CLASS_MISSING,
        "The object does not name its class.",
        pointer,
        "Add the property 'eClass'. " + NearestName.hint("", classes.concreteNames()));
    return Optional.empty();
  }

  private Optional<EClass> classNamed(String name, String pointer) {
    List<EClass> found = classes.find(name);
    if (found.size() == 1 && !found.get(0).isAbstract()) {
      return Optional.of(found.get(0));
    }
    if (found.size() == 1) {
      find(
          InstanceRules.CLASS_ABSTRACT,
          "Class '" + name + "' is abstract.",
          pointer,
          concrete(found));
    } else if (found.isEmpty()) {
      String simple = name.substring(Math.max(name.lastIndexOf('.'), name.lastIndexOf(':')) + 1);
      String hint =
          classes.concreteNames().contains(simple)
              ? "Did you mean `" + simple + "`?" // in another package
              : NearestName.hint(simple, classes.concreteNames());
      find(InstanceRules.CLASS_UNKNOWN, "There is no class '" + name + "'.", pointer, hint);
    } else {
      find(
          InstanceRules.CLASS_AMBIGUOUS,
          "There are several classes '" + name + "'.",
          pointer,
          "Write the package too: '" + found.get(0).getEPackage().getName() + "." + name + "'.");
    }
    return Optional.empty();
  }

  private String concrete(List<EClass> supertype) {
    List<String> names =
        classes.concreteNames().stream()
            .filter(
                name ->
                    classes.find(name).stream().anyMatch(c -> supertype.get(0).isSuperTypeOf(c)))
            .toList();
    return names.isEmpty() ? "" : "Its concrete classes: " + String.join(", ", names) + ".";
  }

  private void noteId(JsonNode json, String pointer, EObject object) {
    JsonNode id = json.get(ID);
    boolean named = id != null && (id.isTextual() || id.isIntegralNumber());
    if (id != null && !id.isNull() && !named) {
      type("'id' must be a string", id, Document.below(pointer, ID));
    }
    if (!named) {
      return;
    }
    EObject earlier = byId.putIfAbsent(id.asText(), object);
    if (earlier != null) {
      find(
          InstanceRules.ID_DUPLICATE,
          String.format(
              Locale.ROOT,
              "The id '%s' already belongs to the %s in line %d.",
              id.asText(),
              earlier.eClass().getName(),
              origins.locate(earlier).line()),
          Document.below(pointer, ID),
          "");
    }
  }

  private void readFeature(EObject object, String name, JsonNode value, String pointer) {
    EStructuralFeature feature = object.eClass().getEStructuralFeature(name);
    if (name.equals(CLASS) || (name.equals(ID) && feature == null)) {
      return;
    }
    String place = Document.below(pointer, name);
    given.computeIfAbsent(object, key -> new HashSet<>()).add(feature);
    if (feature == null) {
      List<String> known =
          object.eClass().getEAllStructuralFeatures().stream()
              .filter(InstanceObjects::isWritable)
              .map(EStructuralFeature::getName)
              .toList();
      String message = "Class '" + object.eClass().getName() + "' has no feature '" + name + "'.";
      findings.add(
          Diagnostic.of(InstanceRules.FEATURE_UNKNOWN, message, text.atKey(place))
              .withHint(NearestName.hint(name, known)));
    } else if (!isWritable(feature)) {
      find(
          InstanceRules.FEATURE_DERIVED,
          "Feature '" + name + "' is derived from others and cannot be set.",
          place,
          "Leave it out.");
    } else if (feature instanceof EAttribute attribute) {
      attributes.set(object, attribute, value, place);
    } else if (!value.isNull()) {
      readReference(object, (EReference) feature, value, place);
    }
  }

  static boolean isWritable(EStructuralFeature feature) {
    return feature.isChangeable() && !feature.isDerived();
  }

  private void readReference(EObject object, EReference reference, JsonNode value, String place) {
    if (!reference.isMany()) {
      if (value.isArray() && value.size() == 1) {
        readTarget(object, reference, value.get(0), Document.below(place, 0));
      } else {
        readTarget(object, reference, value, place);
      }
    } else if (value.isArray()) {
      for (int i = 0; i < value.size(); i++) {
        readTarget(object, reference, value.get(i), Document.below(place, i));
      }
    } else {
      readTarget(object, reference, value, place);
    }
  }

  private void readTarget(EObject object, EReference reference, JsonNode value, String place) {
    if (value.isTextual() || value.isIntegralNumber()) {
      links.add(new Link(object, reference, value.asText(), place));
    } else if (!reference.isContainment() && isOnlyAnId(value)) {
      links.add(new Link(object, reference, value.get(ID).asText(), place));
    } else if (value.isObject() && reference.isContainment()) {
      readObject(value, place, reference.getEReferenceType())
          .ifPresent(child -> assign(object, reference, child, place));
    } else {
      type("'" + reference.getName() + "' must be the id of its target", value, place);
    }
  }

  /** Returns whether a reference is written as {@code {"id": "x"}}, with or without class. */
  private static boolean isOnlyAnId(JsonNode json) {
    JsonNode id = json.get(ID);
    boolean bare = json.size() == 1 || (json.size() == 2 && json.has(CLASS));
    return id != null && id.isTextual() && bare;
  }

  private void assign(EObject object, EReference reference, EObject child, String place) {
    Assignment.of(object, reference, child)
        .make()
        .ifPresent(problem -> findings.add(problem.withLocation(text.at(place))));
  }

  private void type(String wanted, JsonNode value, String pointer) {
    String message = wanted + ", not " + text.kind(value) + ".";
    find(InstanceRules.VALUE_TYPE, message, pointer, "");
  }

  private void find(Rule rule, String message, String pointer, String hint) {
    findings.add(Diagnostic.of(rule, message, text.at(pointer)).withHint(hint));
  }
}
