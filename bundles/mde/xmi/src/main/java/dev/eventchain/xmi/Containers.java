package dev.eventchain.xmi;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import org.eclipse.emf.ecore.EObject;

/** An element and its chain of containers. */
final class Containers {

  private final Set<EObject> all = Collections.newSetFromMap(new IdentityHashMap<>());
  private final boolean endless;

  /** Collects the element and its containers, which may already form a cycle across files. */
  Containers(EObject element) {
    EObject up = element;
    while (up != null && all.add(up)) {
      up = up.eContainer();
    }
    endless = up != null;
  }

  /** Returns whether the element contains itself. */
  boolean isCircle() {
    return endless;
  }

  /** Returns whether placing the element in, or above, another one would close a cycle. */
  boolean closeCircleBelow(EObject other) {
    return endless || all.contains(other);
  }
}
