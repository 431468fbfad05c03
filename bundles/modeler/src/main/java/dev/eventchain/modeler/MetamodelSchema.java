package dev.eventchain.modeler;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EModelElement;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * The JSON Schema of the nested instance models that {@link InstanceModeler} reads, derived from a
 * metamodel. It keeps to what providers of language models accept in their strict modes: the root
 * is an object, every property is required (optional ones may be null), no others are allowed, and
 * of the combining keywords only {@code anyOf} is used.
 */
public final class MetamodelSchema {

  private static final JsonNodeFactory JSON = JsonNodeFactory.instance;

  private static final Set<Class<?>> INTEGERS =
      Set.of(
          byte.class,
          Byte.class,
          short.class,
          Short.class,
          int.class,
          Integer.class,
          long.class,
          Long.class,
          java.math.BigInteger.class);
  private static final Set<Class<?>> REALS =
      Set.of(double.class, Double.class, float.class, Float.class, java.math.BigDecimal.class);

  private final EClass root;
  private final List<EClass> concrete;
  private final Map<String, EClass> needed = new TreeMap<>();

  private MetamodelSchema(EClass root) {
    this.root = root;
    this.concrete =
        root.getEPackage().getEClassifiers().stream()
            .filter(EClass.class::isInstance)
            .map(EClass.class::cast)
            .filter(eClass -> !eClass.isAbstract())
            .toList();
  }

  /**
   * The schema of an object of a class and everything that it can contain. Features that are
   * derived or transient and those that name the container are left out, and of a pair of opposite
   * references the one that comes first in the metamodel stays.
   *
   * @param root a concrete class
   */
  public static ObjectNode nested(EClass root) {
    return new MetamodelSchema(root).build();
  }

  private ObjectNode build() {
    ObjectNode schema = object(root);
    ObjectNode definitions = JSON.objectNode();
    Map<String, ObjectNode> made = new TreeMap<>();
    Deque<String> open = new ArrayDeque<>(needed.keySet());
    while (!open.isEmpty()) {
      String name = open.poll();
      if (!made.containsKey(name)) {
        made.put(name, object(needed.get(name)));
        open.addAll(needed.keySet());
      }
    }
    made.forEach(definitions::set);
    if (!definitions.isEmpty()) {
      schema.set("$defs", definitions);
    }
    return schema;
  }

  private ObjectNode object(EClass eClass) {
    ObjectNode properties = JSON.objectNode();
    properties.set("eClass", string().set("enum", JSON.arrayNode().add(eClass.getName())));
    properties.set("id", string().put("description", "A name that no other object has."));
    for (EStructuralFeature feature : eClass.getEAllStructuralFeatures()) {
      if (isWritten(feature)) {
        ObjectNode property = feature(feature);
        String documentation = documentation(feature);
        properties.set(
            feature.getName(),
            documentation.isEmpty() ? property : property.put("description", documentation));
      }
    }
    ObjectNode schema = JSON.objectNode().put("type", "object");
    String documentation = documentation(eClass);
    if (!documentation.isEmpty()) {
      schema.put("description", documentation);
    }
    schema.set("properties", properties);
    ArrayNode required = schema.putArray("required");
    properties.fieldNames().forEachRemaining(required::add);
    return schema.put("additionalProperties", false);
  }

  private static boolean isWritten(EStructuralFeature feature) {
    boolean isKey = feature.getName().equals(InstanceObjects.ID); // The object's id is its value.
    if (isKey || !InstanceObjects.isWritable(feature) || feature.isTransient()) {
      return false;
    }
    return !(feature instanceof EReference reference)
        || (!reference.isContainer() && !isSecondOfPair(reference));
  }

  private static boolean isSecondOfPair(EReference reference) {
    EReference opposite = reference.getEOpposite();
    if (opposite == null || reference.isContainment()) {
      return false;
    }
    return position(opposite) < position(reference);
  }

  private static long position(EReference reference) {
    EClass owner = reference.getEContainingClass();
    EPackage ePackage = owner.getEPackage();
    return (long) ePackage.getEClassifiers().indexOf(owner) << 32 | reference.getFeatureID();
  }

  private ObjectNode feature(EStructuralFeature feature) {
    ObjectNode single =
        feature instanceof EAttribute attribute
            ? dataType(attribute.getEAttributeType())
            : target((EReference) feature);
    if (feature.isMany()) {
      return JSON.objectNode().put("type", "array").set("items", single);
    }
    return feature.isRequired() ? single : orNull(single);
  }

  private ObjectNode target(EReference reference) {
    if (!reference.isContainment()) {
      return string();
    }
    List<EClass> options =
        concrete.stream().filter(c -> reference.getEReferenceType().isSuperTypeOf(c)).toList();
    options.forEach(option -> needed.put(option.getName(), option));
    if (options.size() == 1) {
      return pointer(options.get(0));
    }
    ObjectNode any = JSON.objectNode();
    ArrayNode alternatives = any.putArray("anyOf");
    options.forEach(option -> alternatives.add(pointer(option)));
    return any;
  }

  private static ObjectNode pointer(EClassifier eClass) {
    return JSON.objectNode().put("$ref", "#/$defs/" + eClass.getName());
  }

  private static ObjectNode dataType(EDataType type) {
    if (type instanceof EEnum eEnum) {
      ArrayNode literals = JSON.arrayNode();
      eEnum.getELiterals().stream().map(EEnumLiteral::getName).forEach(literals::add);
      return string().set("enum", literals);
    }
    Class<?> javaType = type.getInstanceClass();
    if (INTEGERS.contains(javaType)) {
      return JSON.objectNode().put("type", "integer");
    }
    if (REALS.contains(javaType)) {
      return JSON.objectNode().put("type", "number");
    }
    boolean truth = javaType == boolean.class || javaType == Boolean.class;
    return truth ? JSON.objectNode().put("type", "boolean") : string();
  }

  private static ObjectNode string() {
    return JSON.objectNode().put("type", "string");
  }

  private static ObjectNode orNull(ObjectNode schema) {
    ObjectNode nullable = JSON.objectNode();
    nullable.putArray("anyOf").add(schema).add(JSON.objectNode().put("type", "null"));
    return nullable;
  }

  private static String documentation(EModelElement element) {
    String documentation = EcoreUtil.getDocumentation(element);
    return documentation == null ? "" : documentation.strip();
  }
}
