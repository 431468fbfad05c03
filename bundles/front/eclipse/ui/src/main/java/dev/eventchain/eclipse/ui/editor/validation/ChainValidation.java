package dev.eventchain.eclipse.ui.editor.validation;

import dev.eventchain.model.eventchain.EventChain;
import java.util.List;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.IProgressMonitor;

/** What an editor checks its chain for while a person works on it. */
interface ChainValidation {

  /**
   * Checks a chain, not in the user interface's thread.
   *
   * @param copy nobody changes it meanwhile
   * @param file where the chain is kept, which may hold another state of it
   * @return what was found about elements of the copy; also that nothing could be checked
   */
  List<ElementFinding> validate(EventChain copy, IFile file, IProgressMonitor monitor);
}
