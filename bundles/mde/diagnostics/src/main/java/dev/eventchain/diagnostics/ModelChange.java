package dev.eventchain.diagnostics;

import java.util.Comparator;
import java.util.Objects;

/**
 * A change of an element of a model that resolves a finding: an attribute gets another value.
 *
 * @param title the change in words, as a menu shows it
 * @param place the location of the element
 * @param child the containment reference to the only child that has the attribute, which may be
 *     missing; empty if the element has it itself
 * @param from the value that the attribute has; empty if it may have any or none
 * @param certain whether it is the only change that resolves the finding, and nothing else has to
 *     change with it, so that it may be made without a question
 */
public record ModelChange(
    String title,
    SourceLocation place,
    String child,
    String attribute,
    String from,
    String to,
    boolean certain)
    implements Comparable<ModelChange> {

  private static final Comparator<ModelChange> ORDER =
      Comparator.comparing(ModelChange::place)
          .thenComparing(ModelChange::title)
          .thenComparing(ModelChange::child)
          .thenComparing(ModelChange::attribute)
          .thenComparing(ModelChange::from)
          .thenComparing(ModelChange::to)
          .thenComparing(ModelChange::certain);

  /** Refuses nulls. */
  public ModelChange {
    Objects.requireNonNull(title);
    Objects.requireNonNull(place);
    Objects.requireNonNull(child);
    Objects.requireNonNull(attribute);
    Objects.requireNonNull(from);
    Objects.requireNonNull(to);
  }

  @Override
  public int compareTo(ModelChange other) {
    return ORDER.compare(this, other);
  }
}
