package dev.eventchain.eclipse.ui.text;

import java.util.Arrays;
import java.util.stream.Stream;
import org.eclipse.jface.preference.IPreferenceStore;
import org.eclipse.jface.text.DefaultInformationControl;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.IInformationControlCreator;
import org.eclipse.jface.text.ITextHover;
import org.eclipse.jface.text.contentassist.ContentAssistant;
import org.eclipse.jface.text.contentassist.IContentAssistant;
import org.eclipse.jface.text.hyperlink.IHyperlinkDetector;
import org.eclipse.jface.text.presentation.IPresentationReconciler;
import org.eclipse.jface.text.source.IAnnotationHover;
import org.eclipse.jface.text.source.ISourceViewer;
import org.eclipse.ui.editors.text.EditorsUI;
import org.eclipse.ui.editors.text.TextSourceViewerConfiguration;

/** The configuration of a viewer for constraints or templates. */
final class CodeConfiguration extends TextSourceViewerConfiguration {

  private final CodeEditor editor;

  CodeConfiguration(CodeEditor editor, IPreferenceStore preferences) {
    super(preferences);
    this.editor = editor;
  }

  @Override
  public IPresentationReconciler getPresentationReconciler(ISourceViewer viewer) {
    return null; // the editor draws what the analysis finds
  }

  @Override
  public IContentAssistant getContentAssistant(ISourceViewer viewer) {
    ContentAssistant assistant = new ContentAssistant(true); // asks in the background
    assistant.setContentAssistProcessor(new CodeProposals(editor), IDocument.DEFAULT_CONTENT_TYPE);
    assistant.enableAutoActivation(true);
    assistant.enableColoredLabels(true);
    assistant.setInformationControlCreator(getInformationControlCreator(viewer));
    return assistant;
  }

  @Override
  public IHyperlinkDetector[] getHyperlinkDetectors(ISourceViewer viewer) {
    IHyperlinkDetector[] others = super.getHyperlinkDetectors(viewer);
    return others == null // links are switched off
        ? null
        : Stream.concat(Stream.of(new DeclarationLinks(editor)), Arrays.stream(others))
            .toArray(IHyperlinkDetector[]::new);
  }

  /** Returns windows that show texts as they are: a rule may say {@code a < b}. */
  @Override
  public IInformationControlCreator getInformationControlCreator(ISourceViewer viewer) {
    return parent ->
        new DefaultInformationControl(parent, EditorsUI.getTooltipAffordanceString(), null);
  }

  @Override
  public ITextHover getTextHover(ISourceViewer viewer, String type) {
    return new CodeHover(editor, new ProblemHover(viewer));
  }

  @Override
  public IAnnotationHover getAnnotationHover(ISourceViewer viewer) {
    return new ProblemHover(viewer);
  }
}
