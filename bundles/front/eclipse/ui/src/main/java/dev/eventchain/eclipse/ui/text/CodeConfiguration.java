package dev.eventchain.eclipse.ui.text;

import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import org.eclipse.jface.preference.IPreferenceStore;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.ITextHover;
import org.eclipse.jface.text.contentassist.ContentAssistant;
import org.eclipse.jface.text.contentassist.IContentAssistant;
import org.eclipse.jface.text.presentation.IPresentationReconciler;
import org.eclipse.jface.text.presentation.PresentationReconciler;
import org.eclipse.jface.text.rules.DefaultDamagerRepairer;
import org.eclipse.jface.text.source.IAnnotationHover;
import org.eclipse.jface.text.source.ISourceViewer;
import org.eclipse.ui.editors.text.TextSourceViewerConfiguration;

/** The configuration of a viewer for constraints or templates. */
final class CodeConfiguration extends TextSourceViewerConfiguration {

  private final Language language;
  private final Supplier<Vocabulary> names;

  /**
   * @param names the names of the file's project, read on demand
   */
  CodeConfiguration(Language language, Supplier<Vocabulary> names, IPreferenceStore preferences) {
    super(preferences);
    this.language = language;
    this.names = names;
  }

  @Override
  public String[] getConfiguredContentTypes(ISourceViewer viewer) {
    return new String[] {IDocument.DEFAULT_CONTENT_TYPE, Language.COMMENT, Language.TAG};
  }

  @Override
  public String getConfiguredDocumentPartitioning(ISourceViewer viewer) {
    return Language.PARTITIONING;
  }

  @Override
  public IPresentationReconciler getPresentationReconciler(ISourceViewer viewer) {
    PresentationReconciler reconciler = new PresentationReconciler();
    reconciler.setDocumentPartitioning(Language.PARTITIONING);
    Set<String> types = names.get().types();
    draw(reconciler, Language.COMMENT, text -> one(TokenKind.COMMENT, text));
    draw(reconciler, Language.TAG, text -> OclTokens.ofTag(text, 0, text.length(), types));
    draw(
        reconciler,
        IDocument.DEFAULT_CONTENT_TYPE,
        language == Language.OCL
            ? text -> OclTokens.of(text, types)
            : text -> one(TokenKind.TEXT, text));
    return reconciler;
  }

  private static List<Token> one(TokenKind kind, String text) {
    return text.isEmpty() ? List.of() : List.of(new Token(kind, 0, text.length()));
  }

  private static void draw(
      PresentationReconciler reconciler, String type, Function<String, List<Token>> reader) {
    DefaultDamagerRepairer both = new DefaultDamagerRepairer(new CodeScanner(reader));
    reconciler.setDamager(both, type);
    reconciler.setRepairer(both, type);
  }

  @Override
  public IContentAssistant getContentAssistant(ISourceViewer viewer) {
    ContentAssistant assistant = new ContentAssistant();
    assistant.setDocumentPartitioning(Language.PARTITIONING);
    CodeProposals proposals = new CodeProposals(language, names);
    assistant.setContentAssistProcessor(proposals, IDocument.DEFAULT_CONTENT_TYPE);
    assistant.setContentAssistProcessor(proposals, Language.TAG);
    assistant.enableAutoActivation(true);
    assistant.setInformationControlCreator(getInformationControlCreator(viewer));
    return assistant;
  }

  @Override
  public ITextHover getTextHover(ISourceViewer viewer, String type) {
    return new ProblemHover(viewer);
  }

  @Override
  public IAnnotationHover getAnnotationHover(ISourceViewer viewer) {
    return new ProblemHover(viewer);
  }
}
