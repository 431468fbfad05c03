package dev.eventchain.eclipse.ui.commands;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.eclipse.core.commands.ExecutionEvent;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.runtime.Adapters;
import org.eclipse.jface.viewers.ISelection;
import org.eclipse.jface.viewers.IStructuredSelection;
import org.eclipse.ui.IEditorInput;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.handlers.HandlerUtil;

/** Files and folders that are selected for a command. */
final class Selected {

  private Selected() {}

  /** Returns the selected resources, or else the file of the active editor. */
  static List<IResource> resources(ExecutionEvent event) {
    Set<IResource> found = new LinkedHashSet<>();
    ISelection selection = HandlerUtil.getCurrentSelection(event);
    if (selection instanceof IStructuredSelection several) {
      for (Object each : several) {
        IResource resource = Adapters.adapt(each, IResource.class);
        if (resource != null && resource.isAccessible()) {
          found.add(resource);
        }
      }
    }
    IEditorPart editor = HandlerUtil.getActiveEditor(event);
    if (found.isEmpty() && editor != null) {
      IEditorInput input = editor.getEditorInput();
      IResource file = Adapters.adapt(input, IResource.class);
      if (file != null && file.isAccessible()) {
        found.add(file);
      }
    }
    return new ArrayList<>(found);
  }
}
