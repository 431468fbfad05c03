package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.XmlElement;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * An element of a scenario whose parameters have their values: references to parameters and
 * expressions are replaced, references to catalogs are replaced by their entries, and each
 * attribute has a value of its type. Immutable.
 *
 * @param name its name, that of the standard's latest version
 * @param written the element as it stands in its file; for one that only the latest version has,
 *     the one that stands for it
 * @param values the values of the attributes, Booleans as {@code true} and {@code false}, numbers
 *     without expressions
 */
public record ScenarioElement(
    String name, XmlElement written, Map<String, String> values, List<ScenarioElement> children) {

  /** Copies the attributes and the children. */
  public ScenarioElement {
    values = Map.copyOf(values);
    children = List.copyOf(children);
  }

  /** Creates an element that has the name it is written with. */
  public ScenarioElement(
      XmlElement written, Map<String, String> values, List<ScenarioElement> children) {
    this(written.name(), written, values, children);
  }

  public SourceLocation location() {
    return written.location();
  }

  /** Returns the place of an attribute; that of the element if it is not there. */
  public SourceLocation location(String attribute) {
    return written.location(attribute);
  }

  public boolean has(String attribute) {
    return values.containsKey(attribute);
  }

  /** Returns the value of an attribute that may be left out. */
  public Optional<String> optional(String attribute) {
    return Optional.ofNullable(values.get(attribute));
  }

  /**
   * Returns the value of an attribute.
   *
   * @throws IllegalArgumentException if it is not there
   */
  public String text(String attribute) {
    return optional(attribute)
        .orElseThrow(() -> new IllegalArgumentException(name + " has no " + attribute));
  }

  /** Returns a number, in the unit of the standard: m, s, m/s, rad, kg. */
  public double number(String attribute) {
    return Double.parseDouble(text(attribute));
  }

  /** Returns a number likewise, or another one if the attribute is left out. */
  public double number(String attribute, double otherwise) {
    return has(attribute) ? number(attribute) : otherwise;
  }

  /** Returns a whole number; one that is larger than an {@code int} as the largest one. */
  public int integer(String attribute) {
    return (int) Math.min(Integer.MAX_VALUE, Long.parseLong(text(attribute)));
  }

  public boolean flag(String attribute) {
    return Boolean.parseBoolean(text(attribute));
  }

  /** Returns a Boolean, or another one if the attribute is left out. */
  public boolean flag(String attribute, boolean otherwise) {
    return has(attribute) ? flag(attribute) : otherwise;
  }

  /** Returns the children of a name, in their order. */
  public List<ScenarioElement> children(String child) {
    return children.stream().filter(each -> each.name().equals(child)).toList();
  }

  /** Returns the first child of a name. */
  public Optional<ScenarioElement> child(String child) {
    return children.stream().filter(each -> each.name().equals(child)).findFirst();
  }

  /**
   * Returns the child of a name that the standard requires.
   *
   * @throws IllegalArgumentException if it is not there
   */
  public ScenarioElement required(String child) {
    return child(child).orElseThrow(() -> new IllegalArgumentException(name + " has no " + child));
  }

  /**
   * Returns the only child, of an element that is a choice.
   *
   * @throws IllegalArgumentException if there is none
   */
  public ScenarioElement choice() {
    return children.stream()
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(name + " is empty"));
  }
}
