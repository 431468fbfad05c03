package dev.eventchain.xmi;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import org.eclipse.emf.ecore.EObject;

/** An element and what it is a part of, upwards. */
final class Containers {

  private final Set<EObject> all = Collections.newSetFromMap(new IdentityHashMap<>());
  private final boolean endless;

  /** The element and its containers; over files they can go round in circles already. */
  Containers(EObject element) {
    EObject up = element;
    while (up != null && all.add(up)) {
      up = up.eContainer();
    }
    endless = up != null;
  }

  /** Whether the element is a part of itself. */
  boolean isCircle() {
    return endless;
  }

  /** Whether the element would be a part of itself if it lay directly in, or above, another one. */
  boolean closeCircleBelow(EObject other) {
    return endless || all.contains(other);
  }
}
