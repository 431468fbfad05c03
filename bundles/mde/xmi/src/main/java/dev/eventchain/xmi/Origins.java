package dev.eventchain.xmi;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Where the elements of a model were written: in an XMI file, or in the JSON that the model was
 * made from. A finding about an element thereby points to the text that a person can change.
 */
public final class Origins {

  /** Where elements are that did not come from a file read here. */
  private final IdentityHashMap<EObject, SourceLocation> places = new IdentityHashMap<>();

  /** Where the features of elements are stated, for those of which that is known. */
  private final IdentityHashMap<EObject, Function<EStructuralFeature, Optional<SourceLocation>>>
      features = new IdentityHashMap<>();

  /** The elements of each file that was read. */
  private final List<Offsets> files = new ArrayList<>();

  /** Notes where an element was written, in place of what was known before. */
  public void put(EObject element, SourceLocation location) {
    places.put(element, location);
  }

  /**
   * Notes where the features of an element are stated.
   *
   * @param places asked for one feature at a time; nothing where that is not known
   */
  public void putFeatures(
      EObject element, Function<EStructuralFeature, Optional<SourceLocation>> places) {
    features.put(element, places);
  }

  /** A place to note the elements of a text in. */
  Offsets of(SourceText text) {
    Offsets offsets = new Offsets(text);
    files.add(offsets);
    return offsets;
  }

  /**
   * Where an element was written: its own place, else that of the nearest container that has one,
   * else {@link SourceLocation#NONE}. The location always names an element: a JSON pointer where
   * the model came from JSON, else the path of the element asked for ({@code
   * EventChain[aeb]/software[TTC_Calculation]}).
   */
  public SourceLocation locate(EObject element) {
    for (EObject place = element; place != null; place = place.eContainer()) {
      SourceLocation known = known(place);
      if (known != null) {
        return known.element().isEmpty() ? known.withElement(pathOf(element)) : known;
      }
    }
    return SourceLocation.NONE.withElement(pathOf(element));
  }

  /** Where a feature of an element is stated; the place of the element where that is not known. */
  public SourceLocation locate(EObject element, EStructuralFeature feature) {
    return Optional.ofNullable(features.get(element))
        .flatMap(places -> places.apply(feature))
        .orElseGet(() -> locate(element));
  }

  private SourceLocation known(EObject element) {
    SourceLocation known = places.get(element);
    for (int i = 0; known == null && i < files.size(); i++) {
      int offset = files.get(i).get(element);
      known = offset < 0 ? null : files.get(i).text().at(offset);
    }
    return known;
  }

  private static String pathOf(EObject element) {
    return ModelPath.of(element);
  }
}
