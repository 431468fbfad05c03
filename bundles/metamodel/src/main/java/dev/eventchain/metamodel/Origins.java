package dev.eventchain.metamodel;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.IdentityHashMap;
import java.util.OptionalInt;
import org.eclipse.emf.ecore.EObject;

/**
 * Where the elements of a model were written: in an XMI file, or in the JSON that the model was
 * made from. A finding about an element thereby points to the text that a person can change.
 */
public final class Origins {

  /** Locations, or {@link Mark}s that become locations when somebody asks. */
  private final IdentityHashMap<EObject, Object> places = new IdentityHashMap<>();

  /** A place in a text that is not worked out yet: most elements are never asked for. */
  private record Mark(SourceText text, int offset) {}

  /** Notes where an element was written, in place of what was known before. */
  public void put(EObject element, SourceLocation location) {
    places.put(element, location);
  }

  /** Notes that an element starts at an offset of a text. */
  void put(EObject element, SourceText text, int offset) {
    places.put(element, new Mark(text, offset));
  }

  /** The offset at which an element starts; nothing unless it was noted as an offset. */
  OptionalInt offset(EObject element) {
    return places.get(element) instanceof Mark mark
        ? OptionalInt.of(mark.offset())
        : OptionalInt.empty();
  }

  /** Takes over what another one knows. */
  public void putAll(Origins other) {
    places.putAll(other.places);
  }

  /**
   * Where an element was written: its own place, else that of the nearest container that has one,
   * else {@link SourceLocation#NONE}. The location always names an element: a JSON pointer where
   * the model came from JSON, else the path of the element asked for ({@code
   * EventChain[aeb]/software[TTC_Calculation]}).
   */
  public SourceLocation locate(EObject element) {
    for (EObject place = element; place != null; place = place.eContainer()) {
      Object known = places.get(place);
      if (known != null) {
        SourceLocation location =
            known instanceof Mark mark ? mark.text().at(mark.offset()) : (SourceLocation) known;
        return location.element().isEmpty() ? location.withElement(pathOf(element)) : location;
      }
    }
    return SourceLocation.NONE.withElement(pathOf(element));
  }

  private static String pathOf(EObject element) {
    return ModelPath.of(element);
  }
}
