package dev.eventchain.eclipse.ui.editor;

import java.util.Map;
import java.util.function.Supplier;
import org.eclipse.emf.common.command.CommandStack;
import org.eclipse.ui.IEditorSite;
import org.eclipse.ui.IWorkbenchCommandConstants;
import org.eclipse.ui.handlers.IHandlerService;

/** Undo, redo and revert of the workbench, for an editor. */
final class EditHandlers {

  private final Map<String, EditHandler> handlers;

  /**
   * Handles the commands while the editor is active.
   *
   * @param stack null while the editor shows no chain
   */
  EditHandlers(IEditorSite site, Supplier<CommandStack> stack, EditHandler revert) {
    EditHandler undo =
        new EditHandler(
            () -> stack.get().undo(), () -> stack.get() != null && stack.get().canUndo());
    EditHandler redo =
        new EditHandler(
            () -> stack.get().redo(), () -> stack.get() != null && stack.get().canRedo());
    handlers =
        Map.of(
            IWorkbenchCommandConstants.EDIT_UNDO, undo,
            IWorkbenchCommandConstants.EDIT_REDO, redo,
            IWorkbenchCommandConstants.FILE_REVERT, revert);
    IHandlerService service = site.getService(IHandlerService.class);
    handlers.forEach(service::activateHandler);
  }

  /** Updates all handlers after a change of the undo stack. */
  void update() {
    handlers.values().forEach(EditHandler::update);
  }
}
