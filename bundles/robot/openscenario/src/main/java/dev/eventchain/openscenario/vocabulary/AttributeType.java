package dev.eventchain.openscenario.vocabulary;

import java.util.List;
import java.util.Optional;

/**
 * An attribute of a type of elements.
 *
 * @param type the name of its type: a {@link DataType} in camel case, or an {@link Enumeration}
 * @param uses what each version says that says something new, oldest first; at least one
 * @param otherwise the value where it is left out, if the standard gives one
 * @param latest the name of the latest version for the same; mostly its own name
 */
public record AttributeType(
    String name, String type, List<Use> uses, Optional<String> otherwise, String latest) {

  /** Rule of a version about the presence of an attribute. */
  public record Use(Version since, boolean required) {}

  /** Copies the uses. */
  public AttributeType {
    uses = List.copyOf(uses);
  }

  /** Returns the version that has it first. */
  public Version since() {
    return uses.get(0).since();
  }

  /** Returns whether a version requires it. */
  public boolean isRequired(Version version) {
    boolean required = false;
    for (Use use : uses) {
      if (version.isSince(use.since())) {
        required = use.required();
      }
    }
    return required;
  }
}
