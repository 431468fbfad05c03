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
 * The places of the elements of a model in their XMI file, or in the JSON that the model was made
 * from. A finding about an element can so point to the text to change.
 */
public final class Origins {

  /** The places of elements that were not read from an XMI file. */
  private final IdentityHashMap<EObject, SourceLocation> places = new IdentityHashMap<>();

  /** The places of the features of elements, as far as known. */
  private final IdentityHashMap<EObject, Function<EStructuralFeature, Optional<SourceLocation>>>
      features = new IdentityHashMap<>();

  /** The elements of each file that was read. */
  private final List<Offsets> files = new ArrayList<>();

  /** Sets the place of an element, replacing an earlier one. */
  public void put(EObject element, SourceLocation location) {
    places.put(element, location);
  }

  /**
   * Sets the places of the features of an element.
   *
   * @param places returns the place of a feature; empty if unknown
   */
  public void putFeatures(
      EObject element, Function<EStructuralFeature, Optional<SourceLocation>> places) {
    features.put(element, places);
  }

  /** Returns a new table for the elements of a text. */
  Offsets of(SourceText text) {
    Offsets offsets = new Offsets(text);
    files.add(offsets);
    return offsets;
  }

  /**
   * Returns the place of an element, else of the nearest container that has one, else {@link
   * SourceLocation#NONE}. The location always names an element: a JSON pointer where the model came
   * from JSON, else the path of the element asked for ({@code
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

  /** Returns the place of a feature of an element; the place of the element if unknown. */
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
