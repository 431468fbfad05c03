package dev.eventchain.openscenario.vocabulary;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;

/**
 * A type of elements.
 *
 * @param since the version that has it first
 * @param contents what may stand in its elements, by the version that says so first
 * @param children the children of all versions: their types by name
 * @param hasText whether text may stand in its elements
 */
public record ElementType(
    String name,
    Version since,
    Map<String, AttributeType> attributes,
    NavigableMap<Version, Content> contents,
    Map<String, String> children,
    boolean hasText) {

  /** Copies the maps, in their order. */
  public ElementType {
    attributes = Collections.unmodifiableMap(new LinkedHashMap<>(attributes));
    contents = Collections.unmodifiableNavigableMap(new TreeMap<>(contents));
    children = Collections.unmodifiableMap(new LinkedHashMap<>(children));
  }

  /** Returns an attribute. */
  public Optional<AttributeType> attribute(String attribute) {
    return Optional.ofNullable(attributes.get(attribute));
  }

  /**
   * Returns what may stand in an element.
   *
   * @param version the version; for one before the type itself, its first one counts
   */
  public Content content(Version version) {
    Map.Entry<Version, Content> content = contents.floorEntry(version);
    return content == null ? contents.firstEntry().getValue() : content.getValue();
  }
}
