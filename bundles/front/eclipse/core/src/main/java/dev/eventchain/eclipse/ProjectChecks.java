package dev.eventchain.eclipse;

import dev.eventchain.check.EditorRules;
import dev.eventchain.check.ProjectValidation;
import dev.eventchain.check.Validation;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.IWorkspace;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.ICoreRunnable;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.QualifiedName;
import org.eclipse.core.runtime.SubMonitor;

/**
 * Findings in an Eclipse project so far, and their markers. The builder and the command Validate
 * share it, so that neither leaves stale markers of the other. Callers hold the project as
 * scheduling rule.
 */
public final class ProjectChecks {

  /**
   * Largest number of markers per unit; a further marker states the number of remaining findings.
   */
  static final int MOST_MARKERS = 1000;

  private static final QualifiedName KEY = new QualifiedName(EventchainCore.ID, "checks");

  private final IProject project;

  /** Results of the units, in the order of the units. */
  private Map<CheckUnit, Validation> results = new LinkedHashMap<>();

  /** The validations of the folders in the project, each with the time limit it has. */
  private final Map<Path, ProjectValidation> validations = new HashMap<>();

  private Duration timeLimit = Duration.ZERO;

  private boolean complete;

  private ProjectChecks(IProject project) {
    this.project = project;
  }

  /**
   * Returns the checks of a project, which last as long as it is open.
   *
   * @throws CoreException if it is closed or gone
   */
  public static ProjectChecks of(IProject project) throws CoreException {
    synchronized (KEY) {
      Object known = project.getSessionProperty(KEY);
      if (known instanceof ProjectChecks checks) {
        return checks;
      }
      ProjectChecks checks = new ProjectChecks(project);
      project.setSessionProperty(KEY, checks);
      return checks;
    }
  }

  /** Returns whether everything has been checked since the project was opened. */
  boolean isComplete() {
    return complete;
  }

  private List<CheckUnit> units() throws CoreException {
    if (!timeLimit.equals(Preferences.timeLimit())) {
      timeLimit = Preferences.timeLimit();
      validations.clear();
    }
    return CheckedFiles.of(project)
        .units(path -> validations.computeIfAbsent(path, this::validation));
  }

  private ProjectValidation validation(Path path) {
    ProjectFolder folder = new ProjectFolder(path);
    return new ProjectValidation(folder, folder.defaultOutput(), timeLimit);
  }

  /** Forgets everything and removes the markers. */
  void forget() throws CoreException {
    results.clear();
    validations.clear();
    complete = false;
    if (project.isAccessible()) {
      project.deleteMarkers(EventchainCore.PROBLEM, true, IResource.DEPTH_INFINITE);
    }
  }

  /**
   * Checks everything in the project.
   *
   * @throws org.eclipse.core.runtime.OperationCanceledException if people cancelled it; then the
   *     next build checks everything
   */
  public CheckSummary checkAll(IProgressMonitor monitor) throws CoreException {
    return check(units(), Set.of(), monitor);
  }

  /** Checks the units that depend on changed, added or removed files. */
  CheckSummary checkChanged(Collection<IFile> changed, IProgressMonitor monitor)
      throws CoreException {
    List<CheckUnit> units = units();
    Set<CheckUnit> good = new HashSet<>(results.keySet());
    good.removeIf(unit -> changed.stream().anyMatch(unit::dependsOn));
    return check(units, good, monitor);
  }

  /**
   * Checks the selected resources, whether they have changed or not.
   *
   * @param selected files and folders of the project
   */
  public CheckSummary check(Collection<? extends IResource> selected, IProgressMonitor monitor)
      throws CoreException {
    List<CheckUnit> units = units();
    Set<CheckUnit> others = new HashSet<>(units);
    others.removeIf(unit -> selected.stream().anyMatch(each -> isAbout(unit, each)));
    return check(units, others, monitor);
  }

  private static boolean isAbout(CheckUnit unit, IResource selected) {
    boolean contains = selected.getFullPath().isPrefixOf(unit.subject().getFullPath());
    boolean part =
        unit instanceof ProjectUnit && selected instanceof IFile file && unit.dependsOn(file);
    return contains || part;
  }

  /** Checks units except some, which keep earlier results if there are any. */
  private CheckSummary check(List<CheckUnit> units, Set<CheckUnit> spared, IProgressMonitor monitor)
      throws CoreException {
    SubMonitor progress = SubMonitor.convert(monitor, units.size() + 1);
    boolean known = complete;
    complete = false; // until all checks are done
    Map<CheckUnit, Validation> now = new LinkedHashMap<>();
    List<CheckUnit> checked = new ArrayList<>();
    for (CheckUnit unit : units) {
      progress.split(1); // throws if cancelled
      if (!spared.contains(unit) || !results.containsKey(unit)) {
        progress.subTask(unit.subject().getFullPath().toString());
        now.put(unit, CheckUnit.attempt(unit));
        checked.add(unit);
      } else {
        now.put(unit, results.get(unit));
      }
    }
    results = now;
    publish(progress.split(1));
    complete = known || now.size() == units.size();
    return CheckSummary.of(checked.stream().map(now::get).toList());
  }

  /** Updates the markers to the results; equal ones are kept, so that views do not flicker. */
  private void publish(IProgressMonitor monitor) throws CoreException {
    MarkerTexts texts = new MarkerTexts();
    Set<FindingMarker> wanted = new HashSet<>();
    results.forEach(
        (unit, validation) ->
            shown(validation.diagnostics())
                .forEach(each -> wanted.add(FindingMarker.of(each, unit.subject(), texts))));
    project
        .getWorkspace()
        .run((ICoreRunnable) ignored -> replace(wanted), project, IWorkspace.AVOID_UPDATE, monitor);
  }

  private static List<Diagnostic> shown(List<Diagnostic> found) {
    if (found.size() <= MOST_MARKERS) {
      return found;
    }
    List<Diagnostic> sorted = new ArrayList<>(found);
    sorted.sort(Comparator.comparing(Diagnostic::severity)); // errors first
    List<Diagnostic> shown = new ArrayList<>(sorted.subList(0, MOST_MARKERS));
    Diagnostic next = sorted.get(MOST_MARKERS);
    String more = Coverage.counted(found.size() - MOST_MARKERS, "finding");
    shown.add(
        new Diagnostic(
            EditorRules.FINDINGS_MORE,
            next.severity(),
            "Not shown: " + more + " more.",
            SourceLocation.of(next.location().file()),
            "'eventchain validate' on the command line shows all.",
            "",
            List.of()));
    return shown;
  }

  private void replace(Set<FindingMarker> wanted) throws CoreException {
    Set<FindingMarker> missing = new HashSet<>(wanted);
    for (IMarker marker :
        project.findMarkers(EventchainCore.PROBLEM, true, IResource.DEPTH_INFINITE)) {
      Map<String, Object> attributes = marker.getAttributes();
      boolean stays =
          attributes != null && missing.remove(new FindingMarker(marker.getResource(), attributes));
      if (!stays) {
        marker.delete();
      }
    }
    for (FindingMarker each : missing) {
      if (each.resource().exists()) {
        each.resource().createMarker(EventchainCore.PROBLEM, each.attributes());
      }
    }
  }
}
