package dev.eventchain.eclipse.ui.editor.validation;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.eclipse.EventchainFolders;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.RosDistribution;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.core.resources.IContainer;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IFolder;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.runtime.IPath;

/**
 * The message types available to a chain: the standard ones of the release of ROS 2 that its
 * project names, and those of {@code software-base/msg} of the nearest folder above it.
 */
public final class ProjectMessages implements Supplier<Optional<MessageCatalog>> {

  private static final IPath FOLDER = IPath.fromPortableString(ProjectLayout.MESSAGES);

  private final Supplier<IFile> chain;
  private volatile Optional<MessageCatalog> known = Optional.empty();

  public ProjectMessages(Supplier<IFile> chain) {
    this.chain = chain;
  }

  /** Reads the current message files; possibly many, so not on the user interface's thread. */
  Optional<MessageCatalog> read() {
    known = Optional.of(catalog());
    return known;
  }

  private MessageCatalog catalog() {
    RosDistribution distribution = distribution();
    for (IContainer folder = chain.get().getParent();
        folder != null && folder.getType() != IResource.ROOT;
        folder = folder.getParent()) {
      IFolder messages = folder.getFolder(FOLDER);
      if (messages.exists() && messages.getLocation() != null) {
        return of(distribution, messages);
      }
    }
    return MessageCatalog.of(distribution, List.of());
  }

  private static MessageCatalog of(RosDistribution distribution, IFolder messages) {
    try {
      return MessageCatalog.of(distribution, List.of(messages.getLocation().toPath()));
    } catch (DiagnosticException e) { // a folder that was deleted meanwhile
      return MessageCatalog.of(distribution, List.of());
    }
  }

  private RosDistribution distribution() {
    try {
      return EventchainFolders.around(chain.get())
          .flatMap(folder -> Optional.ofNullable(folder.getLocation()))
          .map(location -> new ProjectFolder(location.toPath()).distribution())
          .orElse(RosDistribution.DEFAULT);
    } catch (DiagnosticException e) { // a marker of eventchain.yaml says so
      return RosDistribution.DEFAULT;
    }
  }

  /** Returns the messages that were last read; empty before. */
  @Override
  public Optional<MessageCatalog> get() {
    return known;
  }
}
