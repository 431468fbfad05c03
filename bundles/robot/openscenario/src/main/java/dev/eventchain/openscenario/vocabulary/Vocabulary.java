package dev.eventchain.openscenario.vocabulary;

import java.util.Collection;
import java.util.Collections;
import java.util.Map;
import java.util.Optional;

/** All types of elements and all enumerations of OpenSCENARIO XML 1.0 to 1.3. Immutable. */
public final class Vocabulary {

  private static final Vocabulary STANDARD = VocabularyReader.read("vocabulary.txt");

  private final Map<String, ElementType> elements;
  private final Map<String, Enumeration> enumerations;

  Vocabulary(Map<String, ElementType> elements, Map<String, Enumeration> enumerations) {
    this.elements = Collections.unmodifiableMap(elements);
    this.enumerations = Collections.unmodifiableMap(enumerations);
  }

  /** Returns that of the standard. */
  public static Vocabulary standard() {
    return STANDARD;
  }

  /** Returns the type of the root, {@code OpenSCENARIO}. */
  public ElementType root() {
    return element("OpenScenario");
  }

  /** Returns all types of elements, by name. */
  public Collection<ElementType> elements() {
    return elements.values();
  }

  /** Returns all enumerations, by name. */
  public Collection<Enumeration> enumerations() {
    return enumerations.values();
  }

  /**
   * Returns a type of elements.
   *
   * @throws IllegalArgumentException if there is none
   */
  public ElementType element(String type) {
    ElementType found = elements.get(type);
    if (found == null) {
      throw new IllegalArgumentException("no type " + type);
    }
    return found;
  }

  /** Returns an enumeration. */
  public Optional<Enumeration> enumeration(String type) {
    return Optional.ofNullable(enumerations.get(type));
  }
}
