package dev.eventchain.eclipse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IProjectDescription;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.Status;

/**
 * Identifiers of this bundle's contributions to the platform; adds them to and removes them from
 * projects.
 */
public final class EventchainCore {

  /** Identifier of this bundle. */
  public static final String ID = "dev.eventchain.eclipse";

  /** The nature of projects whose models, rules and templates are checked as they are saved. */
  public static final String NATURE = ID + ".nature";

  /** The builder that checks them. */
  public static final String BUILDER = ID + ".builder";

  /** Type of the markers of findings; {@link FindingMarker} has their attributes. */
  public static final String PROBLEM = ID + ".problem";

  /** The content type of files that hold an event chain. */
  public static final String CHAIN = ID + ".chain";

  private EventchainCore() {}

  /**
   * Returns whether a project has the nature; false if it is closed or deleted.
   *
   * @param project any project
   */
  public static boolean hasNature(IProject project) {
    try {
      return project.isAccessible() && project.hasNature(NATURE);
    } catch (CoreException e) {
      return false; // closed in the meantime
    }
  }

  /**
   * Gives a project the nature, or takes it away together with the markers.
   *
   * @throws CoreException if the project is closed, or its description may not be written
   */
  public static void setNature(IProject project, boolean wanted, IProgressMonitor monitor)
      throws CoreException {
    if (hasNature(project) == wanted) {
      return;
    }
    IProjectDescription description = project.getDescription();
    List<String> natures = new ArrayList<>(Arrays.asList(description.getNatureIds()));
    if (wanted) {
      natures.add(NATURE);
    } else {
      natures.remove(NATURE);
    }
    description.setNatureIds(natures.toArray(String[]::new));
    project.setDescription(description, monitor);
  }

  /** Returns the status of a failure, for the platform's dialogs. */
  static IStatus failure(String message, Throwable cause) {
    return new Status(IStatus.ERROR, ID, message, cause);
  }
}
