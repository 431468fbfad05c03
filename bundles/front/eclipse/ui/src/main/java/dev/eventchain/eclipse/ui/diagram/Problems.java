package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.eclipse.EventchainCore;
import dev.eventchain.eclipse.FindingMarker;
import dev.eventchain.model.diagram.ChainDiagram;
import dev.eventchain.model.diagram.ChainDiagram.Box;
import dev.eventchain.xmi.Origins;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.emf.ecore.EObject;

/** Findings about a file, by box. */
final class Problems {

  /** A finding; higher severities are worse. */
  record Problem(String element, int severity, String message) {}

  private static final Comparator<Problem> WORST_FIRST =
      Comparator.comparingInt(Problem::severity).reversed();

  private final List<List<Problem>> byBox = new ArrayList<>();

  private Problems() {}

  /**
   * Returns the findings by box, worst first.
   *
   * @param file the file; without findings if null or deleted
   */
  static Problems of(IFile file, ChainDiagram diagram) {
    Map<String, Set<Problem>> byPath = byPath(read(file));
    Problems problems = new Problems();
    for (Box box : diagram.boxes()) {
      Set<Problem> found = new LinkedHashSet<>();
      for (String path : byPath.isEmpty() ? List.<String>of() : paths(box)) {
        found.addAll(byPath.getOrDefault(path, Set.of()));
      }
      List<Problem> sorted = new ArrayList<>(found);
      sorted.sort(WORST_FIRST);
      problems.byBox.add(sorted);
    }
    return problems;
  }

  /** Returns the findings by the paths of their elements and of all containers. */
  private static Map<String, Set<Problem>> byPath(List<Problem> all) {
    Map<String, Set<Problem>> byPath = new HashMap<>();
    for (Problem problem : all) {
      String path = problem.element();
      for (int end = path.length(); end > 0; end = path.lastIndexOf('/', end - 1)) {
        byPath.computeIfAbsent(path.substring(0, end), key -> new LinkedHashSet<>()).add(problem);
      }
    }
    return byPath;
  }

  private static List<Problem> read(IFile file) {
    List<Problem> all = new ArrayList<>();
    if (file != null && file.isAccessible()) {
      try {
        for (IMarker marker :
            file.findMarkers(EventchainCore.PROBLEM, true, IResource.DEPTH_ZERO)) {
          String element = marker.getAttribute(FindingMarker.ELEMENT, "");
          if (!element.isEmpty()) {
            all.add(
                new Problem(
                    element,
                    marker.getAttribute(IMarker.SEVERITY, IMarker.SEVERITY_INFO),
                    marker.getAttribute(IMarker.MESSAGE, "")));
          }
        }
      } catch (CoreException e) {
        return List.of(); // the file was deleted meanwhile
      }
    }
    return all;
  }

  private static List<String> paths(Box box) {
    return box.elements().stream().map(Problems::path).distinct().toList();
  }

  /** Returns the path of an element, as in findings. */
  static String path(EObject element) {
    return new Origins().locate(element).element();
  }

  /** Returns the worst severity at each box; -1 for none. */
  List<Integer> severities() {
    return byBox.stream().map(all -> all.isEmpty() ? -1 : all.get(0).severity()).toList();
  }

  /** Returns the messages of the findings at a box. */
  List<String> messages(int box) {
    return box < byBox.size() ? byBox.get(box).stream().map(Problem::message).toList() : List.of();
  }
}
