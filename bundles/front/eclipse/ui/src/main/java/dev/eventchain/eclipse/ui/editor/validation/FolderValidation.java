package dev.eventchain.eclipse.ui.editor.validation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.eclipse.ChainFindings;
import dev.eventchain.eclipse.ChainFindings.Found;
import dev.eventchain.eclipse.EventchainFolders;
import dev.eventchain.model.eventchain.EventChain;
import java.util.List;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.IProgressMonitor;

/**
 * Checks a chain with its Eventchain project, like the builder; outside of projects, with the
 * standard checks.
 */
public final class FolderValidation implements ChainValidation {

  private final ProjectMessages messages;

  /**
   * @param messages the messages for the fields, read again with each check
   */
  public FolderValidation(ProjectMessages messages) {
    this.messages = messages;
  }

  @Override
  public List<ElementFinding> validate(EventChain copy, IFile file, IProgressMonitor monitor) {
    messages.read();
    try {
      ChainFindings checked = ChainFindings.of(copy, EventchainFolders.checksFor(file));
      return checked.evaluations() == 0 && checked.found().isEmpty()
          ? List.of(new ElementFinding(nothing(), copy, null))
          : checked.found().stream().map(found -> finding(found, copy)).toList();
    } catch (DiagnosticException e) { // rules, signals or requirements that cannot be read
      return e.diagnostics().stream().map(each -> new ElementFinding(each, copy, null)).toList();
    }
  }

  private static ElementFinding finding(Found found, EventChain chain) {
    return new ElementFinding(
        found.diagnostic(), found.element().orElse(chain), found.feature().orElse(null));
  }

  private static Diagnostic nothing() {
    return ChainFindings.nothingChecked("Nothing of the chain was checked.");
  }
}
