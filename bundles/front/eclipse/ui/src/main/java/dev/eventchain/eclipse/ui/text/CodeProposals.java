package dev.eventchain.eclipse.ui.text;

import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Completion;
import java.util.List;
import org.eclipse.jface.text.ITextViewer;
import org.eclipse.jface.text.contentassist.ICompletionProposal;
import org.eclipse.jface.text.contentassist.IContentAssistProcessor;
import org.eclipse.jface.text.contentassist.IContextInformation;
import org.eclipse.jface.text.contentassist.IContextInformationValidator;

/** Proposes what the analysis does; called in the background. */
final class CodeProposals implements IContentAssistProcessor {

  private final CodeEditor editor;

  CodeProposals(CodeEditor editor) {
    this.editor = editor;
  }

  @Override
  public ICompletionProposal[] computeCompletionProposals(ITextViewer viewer, int offset) {
    CodeText text = editor.text();
    if (text == null) {
      return new ICompletionProposal[0];
    }
    CodeText.Present present = text.present();
    List<Completion> found = text.ask(offset, Analysis::completions).join().orElse(List.of());
    return found.stream()
        .map(each -> CodeProposal.of(each, present, offset))
        .filter(each -> each.fits(present.text().substring(each.start(), offset)))
        .toArray(ICompletionProposal[]::new);
  }

  @Override
  public IContextInformation[] computeContextInformation(ITextViewer viewer, int offset) {
    return new IContextInformation[0];
  }

  @Override
  public char[] getCompletionProposalAutoActivationCharacters() {
    return new char[] {'.', '[', '>', ':'};
  }

  @Override
  public char[] getContextInformationAutoActivationCharacters() {
    return new char[0];
  }

  @Override
  public String getErrorMessage() {
    return null; // the platform's value for no error
  }

  @Override
  public IContextInformationValidator getContextInformationValidator() {
    return null; // there is no such information
  }
}
