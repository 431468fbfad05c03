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

/** What the platform knows this bundle's contributions by, and how projects get and lose them. */
public final class EventchainCore {

  /** This bundle. */
  public static final String ID = "dev.eventchain.eclipse";

  /** The nature of projects whose models, rules and templates are checked as they are saved. */
  public static final String NATURE = ID + ".nature";

  /** The builder that checks them. */
  public static final String BUILDER = ID + ".builder";

  /** The type of the markers that findings become; {@link FindingMarker} has their attributes. */
  public static final String PROBLEM = ID + ".problem";

  /** The content type of files that hold an event chain. */
  public static final String CHAIN = ID + ".chain";

  private EventchainCore() {}

  /**
   * Whether a project has the nature; not if it is closed or gone.
   *
   * @param project any project
   */
  public static boolean hasNature(IProject project) {
    try {
      return project.isAccessible() && project.hasNature(NATURE);
    } catch (CoreException e) {
      return false; // closed since the question was asked
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

  /** A failure that people are told of, as the platform's own dialogs show it. */
  static IStatus failure(String message, Throwable cause) {
    return new Status(IStatus.ERROR, ID, message, cause);
  }
}
