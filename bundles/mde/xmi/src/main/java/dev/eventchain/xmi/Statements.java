package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Diagnostic;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
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
  private final IdentityHashMap<EObject, List<EStructuralFeature>> filled = new IdentityHashMap<>();

  /** Lists of elements that were read to the end, for the next ones. */
  private final List<List<EStructuralFeature>> free = new ArrayList<>();

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

  /** Notes a reference whose other end must be in the file of its target. */
  void noteEnd(EObject element, EReference feature, Object target, int tag) {
    ends.add(new End(element, feature, target, tag));
  }

  /** As {@link #noteEnd} for each id of a text; one with a {@code #} becomes an element first. */
  void noteEnds(EObject element, EReference reference, String ids, int tag) {
    for (String id : idsIn(ids)) {
      if (id.lastIndexOf('#') <= 0) {
        noteEnd(element, reference, id.startsWith("#") ? id.substring(1) : id, tag);
      }
    }
  }

  /** The ids and URIs of a text, without the names of classes that may be before URIs. */
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

  /** Whether both ends of a reference are written: neither containers nor what is derived is. */
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
    if (feature.isMany()) {
      return false;
    }
    List<EStructuralFeature> known = filled.get(element);
    if (known == null) {
      known = free.isEmpty() ? new ArrayList<>() : free.remove(free.size() - 1);
      filled.put(element, known);
    } else if (known.contains(feature)) {
      return true;
    }
    known.add(feature);
    return false;
  }

  /** Forgets an element that is read to its end. */
  void close(EObject element) {
    List<EStructuralFeature> known = filled.remove(element);
    if (known != null) {
      known.clear();
      free.add(known);
    }
  }
}
