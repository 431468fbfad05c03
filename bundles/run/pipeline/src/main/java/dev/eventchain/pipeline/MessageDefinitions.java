package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.RosDistribution;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Message definitions of folders as nodes that are run by themselves read them.
 *
 * @param json for {@code python -m eventchain_ros2 --messages FILE}; empty if a definition is wrong
 * @param diagnostics what is wrong with the definitions
 */
public record MessageDefinitions(String json, List<Diagnostic> diagnostics) {

  /**
   * Reads folders.
   *
   * @param distribution the id of the release of ROS 2 whose standard types they use, one of {@link
   *     #distributions}; where the runtime does not know them, they are in the text, too. By
   *     default that of the project around the first folder, or Humble
   * @param folders each holds {@code PACKAGE/msg/NAME.msg} or {@code NAME.idl}; a later one hides
   *     an earlier one
   * @throws dev.eventchain.diagnostics.DiagnosticException {@code file.unreadable}
   */
  public static MessageDefinitions of(Optional<String> distribution, List<Path> folders) {
    MessageCatalog catalog = MessageCatalog.of(used(distribution, folders), folders);
    List<Diagnostic> found = catalog.diagnostics();
    String json = Diagnostic.anyError(found) ? "" : catalog.ownDefinitions();
    return new MessageDefinitions(json, found);
  }

  private static RosDistribution used(Optional<String> id, List<Path> folders) {
    return id.flatMap(RosDistribution::of)
        .or(
            () ->
                folders.stream()
                    .findFirst()
                    .flatMap(ProjectFolder::around)
                    .map(ProjectFolder::distribution))
        .orElse(RosDistribution.DEFAULT);
  }

  /** Returns the ids of the known releases of ROS 2. */
  public static List<String> distributions() {
    return RosDistribution.ids();
  }
}
