package dev.eventchain.metamodel;

import dev.eventchain.diagnostics.Diagnostic;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.StringTokenizer;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * What one file says, noted while it is read: EMF's reader drops some of it without a word, such as
 * a reference whose opposite end the file does not name.
 */
final class Statements {

  /**
   * A reference with two ends.
   *
   * @param target the element, or its id in the file
   * @param tag the offset of the element's start tag
   */
  record End(EObject element, EReference feature, Object target, int tag) {}

  private final List<End> ends = new ArrayList<>();

  /** The features for one value that have theirs, of the elements that are not read to the end. */
  private final IdentityHashMap<EObject, Set<EStructuralFeature>> filled = new IdentityHashMap<>();

  /** What was found wrong with the statements while references were resolved. */
  private final List<Diagnostic> faults = new ArrayList<>();

  List<Diagnostic> faults() {
    return faults;
  }

  void addFault(Diagnostic fault) {
    faults.add(fault);
  }

  List<End> ends() {
    return ends;
  }

  /** Notes a reference if its other end must stand in the file of its target. */
  void noteEnd(EObject element, EStructuralFeature feature, Object target, int tag) {
    if (feature instanceof EReference reference && hasWrittenOpposite(reference)) {
      ends.add(new End(element, reference, target, tag));
    }
  }

  /** As {@link #noteEnd} for each id of a text; one with a {@code #} becomes an element first. */
  void noteEnds(EObject element, EReference reference, String ids, int tag) {
    if (!hasWrittenOpposite(reference)) {
      return;
    }
    for (String id : idsIn(ids)) {
      if (id.lastIndexOf('#') <= 0) {
        noteEnd(element, reference, id.startsWith("#") ? id.substring(1) : id, tag);
      }
    }
  }

  /** The ids and URIs of a text, without the names of classes that may stand before URIs. */
  static List<String> idsIn(String text) {
    List<String> ids = new ArrayList<>();
    for (StringTokenizer tokens = new StringTokenizer(text); tokens.hasMoreTokens(); ) {
      String token = tokens.nextToken();
      if (token.indexOf('#') >= 0 || token.indexOf(':') < 0) {
        ids.add(token);
      }
    }
    return ids;
  }

  /** EMF writes neither containers nor what it derives. */
  static boolean hasWrittenOpposite(EReference reference) {
    EReference opposite = reference.getEOpposite();
    return opposite != null
        && isWritten(reference)
        && isWritten(opposite)
        && opposite.getEOpposite() == reference;
  }

  private static boolean isWritten(EReference reference) {
    return !reference.isTransient()
        && !reference.isVolatile()
        && !reference.isDerived()
        && !reference.isContainment()
        && !reference.isContainer();
  }

  /** Notes that a feature for one value gets it; whether it had got one before. */
  boolean fill(EObject element, EStructuralFeature feature) {
    return !feature.isMany()
        && !filled.computeIfAbsent(element, none -> new HashSet<>()).add(feature);
  }

  /** Forgets an element that is read to its end. */
  void close(EObject element) {
    filled.remove(element);
  }
}
