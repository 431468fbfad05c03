package dev.eventchain.jsonmodels;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Collection;
import java.util.Date;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EModelElement;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * The JSON Schema of the instance models that {@link InstanceModeler} reads, derived from a
 * metamodel, in two shapes. Both use only what providers of language models accept in their strict
 * modes: the root is an object, additional properties are not allowed, {@code anyOf} is the only
 * combining keyword, and numbers, texts and arrays have no bounds.
 *
 * <p>Derived, transient and container features are left out; of two opposite references, only the
 * first in the metamodel is kept. The modeler checks what a schema cannot express: multiplicities,
 * ranges of numbers, and the classes of referenced objects.
 */
public final class MetamodelSchema {

  private static final JsonNodeFactory JSON = JsonNodeFactory.instance;

  private final Collection<? extends EPackage> metamodels;
  private final EClass root;
  private final Set<EStructuralFeature> without = new HashSet<>();
  private final Set<EStructuralFeature> demanded = new HashSet<>();
  private final Map<EClass, List<String>> ids = new HashMap<>();

  private MetamodelSchema(Collection<? extends EPackage> metamodels, EClass root) {
    this.metamodels = metamodels;
    this.root = root;
  }

  /**
   * Returns the schema of an object of a class and of everything that it can contain.
   *
   * @param metamodels the metamodels of the instance modeler
   * @param root a concrete class
   */
  public static MetamodelSchema of(Collection<? extends EPackage> metamodels, EClass root) {
    return new MetamodelSchema(metamodels, root);
  }

  /** Leaves out features. */
  public MetamodelSchema without(Collection<? extends EStructuralFeature> features) {
    without.addAll(features);
    return this;
  }

  /** Requires features that are optional in the metamodel. */
  public MetamodelSchema demanding(Collection<? extends EStructuralFeature> features) {
    demanded.addAll(features);
    return this;
  }

  /**
   * Sets the ids of all objects of a class, which become an enumeration. Any id stays allowed if
   * one of them is blank or names two objects.
   */
  public MetamodelSchema knowing(EClass eClass, List<String> known) {
    ids.put(eClass, List.copyOf(known));
    return this;
  }

  /**
   * Returns the schema in which contained objects are nested in their containment feature, and each
   * class is a definition. Every property is required; those that are optional in the metamodel may
   * be null. For services that follow pointers and require every property.
   */
  public ObjectNode nested() {
    return new Shape(true).nested();
  }

  /**
   * Returns the schema with an array for each class; containment features hold ids. It has no
   * definitions and no recursion, and properties that are optional in the metamodel are not
   * required. For services without recursion, or with limits for alternatives. Classes whose
   * feature {@code id} is neither text nor integer are left out, as their objects have no ids.
   */
  public ObjectNode flat() {
    return new Shape(false).flat();
  }

  /** The builder of one schema. */
  private final class Shape {

    private final boolean nested;
    private final SchemaClasses classes;

    Shape(boolean nested) {
      this.nested = nested;
      this.classes = new SchemaClasses(metamodels, root, without, !nested);
    }

    ObjectNode nested() {
      ObjectNode schema = object(root);
      ObjectNode definitions = JSON.objectNode();
      for (EClass eClass : classes.contained()) {
        definitions.set(definition(eClass), object(eClass));
      }
      if (!definitions.isEmpty()) {
        schema.set("$defs", definitions);
      }
      return EnumLimits.keep(schema);
    }

    ObjectNode flat() {
      ObjectNode properties = JSON.objectNode();
      for (EClass eClass : classes.used()) {
        properties.set(classes.name(eClass), array(object(eClass)));
      }
      return EnumLimits.keep(closed(properties, names(properties)));
    }

    private ObjectNode object(EClass eClass) {
      ObjectNode properties = JSON.objectNode();
      Set<String> required = new LinkedHashSet<>();
      if (nested) {
        properties.set(InstanceObjects.CLASS, oneOf(List.of(classes.name(eClass))));
        required.add(InstanceObjects.CLASS);
      }
      if (SchemaClasses.hasId(eClass)) {
        properties.set(InstanceObjects.ID, id(eClass));
        required.add(InstanceObjects.ID);
      }
      for (EStructuralFeature feature : classes.features(eClass)) {
        boolean optional = isOptional(feature);
        ObjectNode property = values(feature);
        properties.set(
            feature.getName(),
            described(optional && nested ? orNull(property) : property, feature));
        if (nested || !optional) {
          required.add(feature.getName());
        }
      }
      ObjectNode schema = closed(properties, required);
      String documentation = documentation(eClass);
      return documentation.isEmpty() ? schema : schema.put("description", documentation);
    }

    private ObjectNode id(EClass eClass) {
      EStructuralFeature key = SchemaClasses.key(eClass);
      Optional<ObjectNode> known = known(List.of(eClass));
      ObjectNode id =
          known.orElseGet(
              () ->
                  key == null ? type("string") : dataType(((EAttribute) key).getEAttributeType()));
      return id.put("description", "A name that no other object has.");
    }

    /** Returns whether a feature may be absent; empty arrays are written. */
    private boolean isOptional(EStructuralFeature feature) {
      return !feature.isMany() && !feature.isRequired() && !demanded.contains(feature);
    }

    private ObjectNode values(EStructuralFeature feature) {
      ObjectNode value =
          feature instanceof EAttribute attribute
              ? dataType(attribute.getEAttributeType())
              : target((EReference) feature);
      return feature.isMany() ? array(value) : value;
    }

    private ObjectNode target(EReference reference) {
      List<EClass> targets = classes.targets(reference);
      if (!nested || !reference.isContainment()) {
        return known(targets).orElseGet(() -> type("string"));
      }
      if (targets.size() == 1) {
        return pointer(targets.get(0));
      }
      ObjectNode any = JSON.objectNode();
      ArrayNode alternatives = any.putArray("anyOf");
      targets.forEach(target -> alternatives.add(pointer(target)));
      return any;
    }

    private ObjectNode pointer(EClass eClass) {
      return JSON.objectNode().put("$ref", "#/$defs/" + definition(eClass));
    }

    /** Returns a unique name of a class without special characters of pointers. */
    private String definition(EClass eClass) {
      String name = classes.name(eClass);
      return name.matches("[\\w.]+")
          ? name
          : eClass.getName() + "_" + classes.contained().indexOf(eClass);
    }
  }

  /** Returns the ids of all objects of some classes; empty if those of one are unknown. */
  private Optional<ObjectNode> known(List<EClass> targets) {
    List<String> all = ids.values().stream().flatMap(List::stream).toList();
    boolean clear = all.stream().noneMatch(String::isBlank) && Set.copyOf(all).size() == all.size();
    List<List<String>> known = targets.stream().map(ids::get).toList();
    if (!clear || known.stream().anyMatch(Objects::isNull)) {
      return Optional.empty();
    }
    List<String> values = known.stream().flatMap(List::stream).toList();
    return values.isEmpty() ? Optional.empty() : Optional.of(oneOf(values));
  }

  private static ObjectNode dataType(EDataType type) {
    if (type instanceof EEnum eEnum) {
      return oneOf(eEnum.getELiterals().stream().map(EEnumLiteral::getName).toList());
    }
    ObjectNode schema = type(AttributeValues.jsonType(type).orElseThrow());
    return type.getInstanceClass() == Date.class ? schema.put("format", "date") : schema;
  }

  private static ObjectNode closed(ObjectNode properties, Collection<String> required) {
    ObjectNode schema = type("object");
    schema.set("properties", properties);
    ArrayNode names = schema.putArray("required");
    required.forEach(names::add);
    return schema.put("additionalProperties", false);
  }

  private static Set<String> names(ObjectNode properties) {
    Set<String> names = new LinkedHashSet<>();
    properties.fieldNames().forEachRemaining(names::add);
    return names;
  }

  private static ObjectNode array(ObjectNode items) {
    return type("array").set("items", items);
  }

  private static ObjectNode type(String name) {
    return JSON.objectNode().put("type", name);
  }

  private static ObjectNode oneOf(List<String> values) {
    ObjectNode schema = type("string");
    ArrayNode literals = schema.putArray("enum");
    values.forEach(literals::add);
    return schema;
  }

  private static ObjectNode orNull(ObjectNode schema) {
    ObjectNode nullable = JSON.objectNode();
    nullable.putArray("anyOf").add(schema).add(type("null"));
    return nullable;
  }

  private static ObjectNode described(ObjectNode schema, EModelElement element) {
    String documentation = documentation(element);
    return documentation.isEmpty() ? schema : schema.put("description", documentation);
  }

  private static String documentation(EModelElement element) {
    String documentation = EcoreUtil.getDocumentation(element);
    return documentation == null ? "" : documentation.strip();
  }
}
