package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.eclipse.EventchainCore;
import dev.eventchain.eclipse.diagram.ChainDiagram;
import dev.eventchain.eclipse.diagram.ChainDiagram.Box;
import dev.eventchain.metamodel.Origins;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.emf.ecore.EObject;

/** The findings of a file, at the boxes that they are about. */
final class Problems {

  /** The path of the element that a marker is about, as findings name it. */
  static final String ELEMENT = "element";

  private static final String TYPE = EventchainCore.ID + ".problem";

  /** A finding; more is worse. */
  record Problem(String element, int severity, String message) {}

  private final List<List<Problem>> byBox = new ArrayList<>();

  private Problems() {}

  /**
   * The findings at boxes, worst first.
   *
   * @param file may be null or gone, which has no findings
   */
  static Problems of(IFile file, ChainDiagram diagram) {
    List<Problem> all = read(file);
    Problems problems = new Problems();
    for (Box box : diagram.boxes()) {
      List<String> paths = all.isEmpty() ? List.of() : paths(box);
      problems.byBox.add(
          all.stream()
              .filter(problem -> paths.stream().anyMatch(path -> isIn(problem.element(), path)))
              .toList());
    }
    return problems;
  }

  private static List<Problem> read(IFile file) {
    List<Problem> all = new ArrayList<>();
    if (file != null && file.isAccessible()) {
      try {
        for (IMarker marker : file.findMarkers(TYPE, true, IResource.DEPTH_ZERO)) {
          String element = marker.getAttribute(ELEMENT, "");
          if (!element.isEmpty()) {
            all.add(
                new Problem(
                    element,
                    marker.getAttribute(IMarker.SEVERITY, IMarker.SEVERITY_INFO),
                    marker.getAttribute(IMarker.MESSAGE, "")));
          }
        }
      } catch (CoreException e) {
        return List.of(); // the file went meanwhile
      }
    }
    all.sort(Comparator.comparingInt(Problem::severity).reversed());
    return all;
  }

  private static List<String> paths(Box box) {
    return box.elements().stream().map(Problems::path).distinct().toList();
  }

  /** The path of an element, as findings name it. */
  static String path(EObject element) {
    return new Origins().locate(element).element();
  }

  private static boolean isIn(String path, String container) {
    return path.startsWith(container)
        && (path.length() == container.length() || path.charAt(container.length()) == '/');
  }

  /** The worst severity at each box; -1 for none. */
  List<Integer> severities() {
    return byBox.stream().map(all -> all.isEmpty() ? -1 : all.get(0).severity()).toList();
  }

  /** What the findings at a box say. */
  List<String> messages(int box) {
    return box < byBox.size() ? byBox.get(box).stream().map(Problem::message).toList() : List.of();
  }
}
