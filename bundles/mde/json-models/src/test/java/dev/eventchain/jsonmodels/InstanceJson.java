package dev.eventchain.jsonmodels;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DecimalNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Date;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.eclipse.emf.common.util.Enumerator;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;

/** Writes a model as JSON of a schema, with exactly the properties of the schema. */
final class InstanceJson {

  private static final JsonNodeFactory JSON = JsonNodeFactory.instance;
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final JsonNode schema;
  private final boolean nested;
  private final Map<EObject, JsonNode> ids = new HashMap<>();

  private InstanceJson(JsonNode schema) {
    this.schema = schema;
    this.nested = schema.path("properties").has("eClass");
  }

  static JsonNode of(EObject root, JsonNode schema) {
    InstanceJson json = new InstanceJson(schema);
    List<EObject> all = new ArrayList<>(List.of(root));
    root.eAllContents().forEachRemaining(all::add);
    for (int i = 0; i < all.size(); i++) {
      EStructuralFeature key = all.get(i).eClass().getEStructuralFeature("id");
      Object id = key == null ? null : all.get(i).eGet(key);
      json.ids.put(
          all.get(i),
          id instanceof Integer number ? JSON.numberNode(number) : JSON.textNode("o" + i));
      if (id instanceof String text) {
        json.ids.put(all.get(i), JSON.textNode(text));
      }
    }
    return json.nested ? json.object(root, schema) : json.classes(all);
  }

  private ObjectNode classes(List<EObject> all) {
    ObjectNode classes = JSON.objectNode();
    for (Map.Entry<String, JsonNode> each : schema.get("properties").properties()) {
      ArrayNode objects = classes.putArray(each.getKey());
      all.stream()
          .filter(object -> isNamed(object.eClass(), each.getKey()))
          .forEach(object -> objects.add(object(object, each.getValue().get("items"))));
    }
    return classes;
  }

  private static boolean isNamed(EClass eClass, String name) {
    return name.contains(".")
        ? name.equals(eClass.getEPackage().getName() + "." + eClass.getName())
        : name.equals(eClass.getName());
  }

  private ObjectNode object(EObject object, JsonNode part) {
    ObjectNode json = JSON.objectNode();
    for (Map.Entry<String, JsonNode> property : part.get("properties").properties()) {
      String name = property.getKey();
      if (name.equals("eClass")) {
        json.set(name, property.getValue().get("enum").get(0));
      } else if (name.equals("id")) {
        json.set(name, ids.get(object));
      } else {
        EStructuralFeature feature = object.eClass().getEStructuralFeature(name);
        boolean there = feature.isMany() || !feature.isUnsettable() || object.eIsSet(feature);
        JsonNode value = values(there ? object.eGet(feature) : null, feature);
        if (nested || !value.isNull()) {
          json.set(name, value);
        }
      }
    }
    return json;
  }

  private JsonNode values(Object value, EStructuralFeature feature) {
    if (!(value instanceof List<?> list)) {
      return value(value, feature);
    }
    ArrayNode array = JSON.arrayNode();
    list.forEach(each -> array.add(value(each, feature)));
    return array;
  }

  private JsonNode value(Object value, EStructuralFeature feature) {
    if (value instanceof Enumerator literal) {
      return JSON.textNode(literal.getName());
    }
    if (value instanceof EObject target) {
      if (nested && ((EReference) feature).isContainment()) {
        return object(target, definition(target.eClass()));
      }
      return JSON.textNode(ids.get(target).asText());
    }
    if (value instanceof Date date) {
      return JSON.textNode(new java.text.SimpleDateFormat("yyyy-MM-dd", Locale.ROOT).format(date));
    }
    if (value == null) {
      return JSON.nullNode();
    }
    if (value instanceof BigDecimal number) {
      return DecimalNode.valueOf(number);
    }
    return MAPPER.valueToTree(value);
  }

  private JsonNode definition(EClass eClass) {
    for (JsonNode definition : schema.get("$defs")) {
      if (isNamed(eClass, definition.at("/properties/eClass/enum/0").asText())) {
        return definition;
      }
    }
    throw new AssertionError(eClass);
  }
}
