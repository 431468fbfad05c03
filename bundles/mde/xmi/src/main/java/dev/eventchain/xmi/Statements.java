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
 * The statements of one file, recorded while it is read: EMF's reader drops some silently, such as
 * a reference whose opposite end the file does not name.
 */
final class Statements {

  private final Ends ends = new Ends();

  /** The single-valued features that are already set, of elements that are still being read. */
  private final IdentityHashMap<EObject, List<EStructuralFeature>> filled = new IdentityHashMap<>();

  /** Lists of finished elements, for reuse. */
  private final List<List<EStructuralFeature>> free = new ArrayList<>();

  /** The findings about statements during resolution. */
  private final List<Diagnostic> faults = new ArrayList<>();

  List<Diagnostic> faults() {
    return faults;
  }

  void addFault(Diagnostic fault) {
    faults.add(fault);
  }

  /** Returns the references whose opposite ends must be in the files of their targets. */
  Ends ends() {
    return ends;
  }

  /** Records an end for each of some ids; one with a {@code #} becomes an element first. */
  void noteEnds(EObject element, EReference reference, List<String> ids, int tag) {
    for (String id : ids) {
      if (id.lastIndexOf('#') <= 0) {
        ends.add(element, reference, id.startsWith("#") ? id.substring(1) : id, tag);
      }
    }
  }

  /** Returns the ids and URIs of a text, without class names before URIs. */
  static List<String> idsIn(String text) {
    if (isId(text)) {
      return List.of(text);
    }
    List<String> ids = new ArrayList<>();
    for (StringTokenizer tokens = new StringTokenizer(text); tokens.hasMoreTokens(); ) {
      String token = tokens.nextToken();
      if (token.indexOf('#') >= 0 || token.indexOf(':') < 0) {
        ids.add(token);
      }
    }
    return ids;
  }

  /** Returns whether a text is one id of this file, neither several nor a path nor a URI. */
  static boolean isId(String text) {
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c <= ' ' || c == '#' || c == ':' || c == '/') {
        return false;
      }
    }
    return !text.isEmpty();
  }

  /** Returns whether both ends of a reference are written: not for container and derived ones. */
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

  /** Records the value of a single-valued feature; returns true if it already had one. */
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

  /** Forgets an element that has been read completely. */
  void close(EObject element) {
    List<EStructuralFeature> known = filled.remove(element);
    if (known != null) {
      known.clear();
      free.add(known);
    }
  }
}
