package dev.eventchain.eclipse.ui.editor.model;

import dev.eventchain.eclipse.FindingMarker;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.xmi.Origins;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.core.resources.IMarker;
import org.eclipse.emf.ecore.EObject;

/** The element of a chain that a marker refers to. */
public final class MarkerTarget {

  private MarkerTarget() {}

  /**
   * Finds the element by its path, or by the longest prefix of it that exists; else by its line.
   */
  public static Optional<EObject> find(EditedModel model, IMarker marker) {
    List<EObject> elements = elements(model.chain());
    String path = marker.getAttribute(FindingMarker.ELEMENT, "");
    while (path.contains("/")) {
      Optional<EObject> found = byPath(elements, path);
      if (found.isPresent()) {
        return found;
      }
      path = path.substring(0, path.lastIndexOf('/'));
    }
    int line = marker.getAttribute(IMarker.LINE_NUMBER, 0);
    return path.isEmpty() && line > 0 ? byLine(model, elements, line) : byPath(elements, path);
  }

  /** Returns the path of an element, as in findings. */
  public static String path(EObject element) {
    return new Origins().locate(element).element();
  }

  /** Returns the element at a path. */
  public static Optional<EObject> find(EventChain chain, String path) {
    return byPath(elements(chain), path);
  }

  private static List<EObject> elements(EventChain chain) {
    List<EObject> elements = new ArrayList<>(List.of(chain));
    chain.eAllContents().forEachRemaining(elements::add);
    return elements;
  }

  private static Optional<EObject> byPath(List<EObject> elements, String path) {
    return elements.stream().filter(element -> path(element).equals(path)).findFirst();
  }

  /** Returns the last element that begins at or before a line of the file as read. */
  private static Optional<EObject> byLine(EditedModel model, List<EObject> elements, int line) {
    return elements.stream()
        .filter(element -> model.loaded().origins().locate(element).line() <= line)
        .reduce((first, second) -> second);
  }
}
