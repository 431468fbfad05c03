package dev.eventchain.catalogue.vss;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** A node of the tree: a branch or a signal, with its attributes as written. */
final class VssNode {

  private final String name;
  private final Map<String, VssValue> attributes = new LinkedHashMap<>();
  private final Map<String, VssNode> children = new LinkedHashMap<>();
  private VssValue written;

  /**
   * Creates a node without attributes.
   *
   * @param written the entry that first needs it
   */
  VssNode(String name, VssValue written) {
    this.name = name;
    this.written = written;
  }

  String name() {
    return name;
  }

  Map<String, VssValue> attributes() {
    return attributes;
  }

  Map<String, VssNode> children() {
    return children;
  }

  /** Adds the attributes of an entry, which replace earlier ones. */
  void add(VssValue entry, Map<String, VssValue> more) {
    written = entry;
    attributes.putAll(more);
  }

  Optional<VssValue> value(String attribute) {
    return Optional.ofNullable(attributes.get(attribute)).filter(it -> !it.json().isNull());
  }

  /** Returns a text attribute; empty if it is missing or no text. */
  String text(String attribute) {
    return value(attribute)
        .map(VssValue::json)
        .filter(JsonNode::isTextual)
        .map(JsonNode::asText)
        .orElse("");
  }

  /** Returns whether an attribute is a truth value with the given one. */
  boolean is(String attribute, boolean wanted) {
    return value(attribute)
        .map(VssValue::json)
        .filter(it -> it.isBoolean() && it.booleanValue() == wanted)
        .isPresent();
  }

  /** Returns the location of the last entry about the node. */
  SourceLocation location() {
    return written.key();
  }

  /** Returns a node of another name with the attributes of this one, without children. */
  VssNode instance(String named) {
    VssNode instance = new VssNode(named, written);
    instance.attributes.putAll(attributes);
    instance.attributes.remove(VssInstances.INSTANCES);
    return instance;
  }

  VssNode copy() {
    VssNode copy = new VssNode(name, written);
    copy.attributes.putAll(attributes);
    children.forEach((key, child) -> copy.children.put(key, child.copy()));
    return copy;
  }

  /** Adds attributes and children of another node, which replace those of this one. */
  void merge(VssNode other) {
    add(other.written, other.attributes);
    other.children.forEach(
        (key, child) -> {
          if (children.containsKey(key)) {
            children.get(key).merge(child);
          } else {
            children.put(key, child.copy());
          }
        });
  }
}
