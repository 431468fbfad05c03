package dev.eventchain.eclipse.ui.text;

import org.eclipse.core.commands.AbstractHandler;
import org.eclipse.core.commands.ExecutionEvent;
import org.eclipse.jface.text.ITextSelection;
import org.eclipse.ui.handlers.HandlerUtil;

/** Handles the commands about the name at the caret. */
public final class CodeCommands extends AbstractHandler {

  @Override
  public Object execute(ExecutionEvent event) {
    if (HandlerUtil.getActiveEditor(event) instanceof CodeEditor editor
        && editor.text() != null
        && editor.getSelectionProvider().getSelection() instanceof ITextSelection selection) {
      String id = event.getCommand().getId();
      int offset = selection.getOffset();
      switch (id.substring(id.lastIndexOf('.') + 1)) {
        case "openDeclaration" -> Declarations.open(editor, offset);
        case "findReferences" -> Declarations.references(editor, offset);
        case "rename" -> Renaming.start(editor, offset);
        default -> throw new IllegalStateException(id);
      }
    }
    return null; // the required result of a handler
  }
}
