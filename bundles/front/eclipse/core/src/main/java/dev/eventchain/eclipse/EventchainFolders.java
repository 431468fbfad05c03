package dev.eventchain.eclipse;

import dev.eventchain.check.ChainChecks;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.util.Optional;
import org.eclipse.core.resources.IContainer;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;

/** The folders of Eventchain projects in the workspace, and the checks that hold in them. */
public final class EventchainFolders {

  private EventchainFolders() {}

  /**
   * Returns the checks for the chain in a file: with the rules, signals and requirements of the
   * surrounding Eventchain project, else the standard ones.
   *
   * @param file need not exist
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT with the problems of any file of
   *     that project
   */
  public static ChainChecks checksFor(IFile file) {
    Optional<Path> folder = around(file).flatMap(CheckedFiles::pathOf);
    if (folder.isEmpty()) {
      return ChainChecks.alone(Preferences.timeLimit());
    }
    ProjectFolder project = new ProjectFolder(folder.get());
    return ChainChecks.of(project, project.defaultOutput(), Preferences.timeLimit());
  }

  /** Returns the innermost Eventchain project folder that is or contains a resource. */
  public static Optional<IContainer> around(IResource resource) {
    IContainer folder = resource instanceof IContainer container ? container : resource.getParent();
    while (folder != null && folder.getType() != IResource.ROOT) {
      if (CheckedFiles.isProjectFolder(folder)) {
        return Optional.of(folder);
      }
      folder = folder.getParent();
    }
    return Optional.empty();
  }
}
