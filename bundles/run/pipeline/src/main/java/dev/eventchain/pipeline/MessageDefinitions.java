package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.messages.MessageCatalog;
import java.nio.file.Path;
import java.util.List;

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
   * @param folders each holds {@code PACKAGE/msg/NAME.msg} or {@code NAME.idl}; a later one hides
   *     an earlier one
   * @throws dev.eventchain.diagnostics.DiagnosticException {@code file.unreadable}
   */
  public static MessageDefinitions of(List<Path> folders) {
    MessageCatalog catalog = MessageCatalog.of(folders);
    List<Diagnostic> found = catalog.diagnostics();
    String json = Diagnostic.anyError(found) ? "" : catalog.ownDefinitions();
    return new MessageDefinitions(json, found);
  }
}
