package dev.eventchain.eclipse.ui.editor.validation;

import dev.eventchain.model.eventchain.EventChain;
import java.util.List;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.IProgressMonitor;

/** The validation of a chain while a person edits it. */
interface ChainValidation {

  /**
   * Checks a chain, outside the user interface's thread.
   *
   * @param copy a copy that is not changed meanwhile
   * @param file the file of the chain, which may contain another state of it
   * @return the findings about elements of the copy, including one if nothing could be checked
   */
  List<ElementFinding> validate(EventChain copy, IFile file, IProgressMonitor monitor);
}
