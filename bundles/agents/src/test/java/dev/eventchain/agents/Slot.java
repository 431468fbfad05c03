package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A value's place in JSON.
 *
 * @param parent the object or array
 * @param key the key or the position
 * @param path the path from the root, with a star for each position
 * @param root the position or key of the root's child above it
 */
record Slot(JsonNode parent, String key, String path, String root) {

  /** Returns all places below a root, in pre-order. */
  static List<Slot> in(JsonNode root) {
    List<Slot> slots = new ArrayList<>();
    add(root, "", "", slots);
    return slots;
  }

  private static void add(JsonNode parent, String path, String top, List<Slot> slots) {
    List<String> keys = new ArrayList<>();
    parent.fieldNames().forEachRemaining(keys::add);
    for (int i = 0; parent.isArray() && i < parent.size(); i++) {
      keys.add(Integer.toString(i));
    }
    for (String key : keys) {
      String below = path + "/" + (parent.isArray() ? "*" : key);
      Slot slot = new Slot(parent, key, below, top.isEmpty() ? key : top);
      slots.add(slot);
      add(slot.value(), below, slot.root(), slots);
    }
  }

  JsonNode value() {
    return parent.isArray() ? parent.get(Integer.parseInt(key)) : parent.get(key);
  }

  void set(JsonNode value) {
    if (parent instanceof ArrayNode array) {
      array.set(Integer.parseInt(key), value);
    } else {
      ((ObjectNode) parent).set(key, value);
    }
  }

  void set(String value) {
    set(TextNode.valueOf(value));
  }

  void remove() {
    if (parent instanceof ArrayNode array) {
      array.remove(Integer.parseInt(key));
    } else {
      ((ObjectNode) parent).remove(key);
    }
  }

  /** Renames the key in place. */
  void rename(String name) {
    Map<String, JsonNode> properties = new LinkedHashMap<>();
    parent.properties().forEach(each -> properties.put(each.getKey(), each.getValue()));
    ObjectNode object = (ObjectNode) parent;
    object.removeAll();
    properties.forEach((key, value) -> object.set(key.equals(this.key) ? name : key, value));
  }
}
