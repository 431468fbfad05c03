package dev.eventchain.eclipse.ui.text;

import dev.eventchain.eclipse.ui.EventchainUi;
import java.util.List;
import org.eclipse.core.resources.IFile;
import org.eclipse.jface.preference.IPreferenceStore;
import org.eclipse.jface.preference.PreferenceStore;
import org.eclipse.jface.text.DocumentEvent;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.IDocumentListener;
import org.eclipse.jface.text.source.DefaultCharacterPairMatcher;
import org.eclipse.jface.util.IPropertyChangeListener;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.ui.IEditorInput;
import org.eclipse.ui.editors.text.EditorsUI;
import org.eclipse.ui.editors.text.TextEditor;
import org.eclipse.ui.texteditor.ChainedPreferenceStore;
import org.eclipse.ui.texteditor.SourceViewerDecorationSupport;
import org.eclipse.ui.views.contentoutline.IContentOutlinePage;

/** A text editor for a language. */
abstract class CodeEditor extends TextEditor {

  /** Context in which the key bindings of these editors are active. */
  static final String CONTEXT = EventchainUi.ID + ".text.context";

  private static final String BRACKETS = EventchainUi.ID + ".text.brackets";
  private static final String BRACKETS_COLOR = BRACKETS + ".color";

  private final Language language;
  private final IPropertyChangeListener colors = event -> redraw();
  private CodeOutline outline;

  private final IDocumentListener changes =
      new IDocumentListener() {
        @Override
        public void documentAboutToBeChanged(DocumentEvent event) {
          // Only the result matters.
        }

        @Override
        public void documentChanged(DocumentEvent event) {
          if (outline != null) {
            outline.refresh();
          }
        }
      };

  CodeEditor(Language language) {
    this.language = language;
  }

  final Language language() {
    return language;
  }

  @Override
  protected void initializeEditor() {
    super.initializeEditor();
    PreferenceStore own = new PreferenceStore();
    own.setDefault(BRACKETS, true);
    own.setDefault(BRACKETS_COLOR, "128,128,128");
    setPreferenceStore(
        new ChainedPreferenceStore(new IPreferenceStore[] {own, EditorsUI.getPreferenceStore()}));
  }

  @Override
  protected void doSetInput(IEditorInput input) throws org.eclipse.core.runtime.CoreException {
    IDocument before = document();
    if (before != null) {
      before.removeDocumentListener(changes);
    }
    setSourceViewerConfiguration(
        new CodeConfiguration(language, this::names, getPreferenceStore()));
    super.doSetInput(input);
    IDocument now = document();
    if (now != null) {
      now.addDocumentListener(changes);
    }
    if (outline != null) {
      outline.refresh();
    }
  }

  private IDocument document() {
    return getDocumentProvider() == null
        ? null
        : getDocumentProvider().getDocument(getEditorInput());
  }

  private Vocabulary names() {
    IEditorInput input = getEditorInput();
    return Vocabulary.of(input == null ? null : input.getAdapter(IFile.class));
  }

  @Override
  protected void initializeKeyBindingScopes() {
    setKeyBindingScopes(new String[] {CONTEXT});
  }

  @Override
  public void createPartControl(Composite parent) {
    super.createPartControl(parent);
    CodeColors.listen(colors);
  }

  @Override
  protected void configureSourceViewerDecorationSupport(SourceViewerDecorationSupport support) {
    super.configureSourceViewerDecorationSupport(support);
    support.setCharacterPairMatcher(
        new DefaultCharacterPairMatcher("()[]{}".toCharArray(), Language.PARTITIONING));
    support.setMatchingCharacterPainterPreferenceKeys(BRACKETS, BRACKETS_COLOR);
  }

  private void redraw() {
    if (getSourceViewer() != null && !getSourceViewer().getTextWidget().isDisposed()) {
      getSourceViewer().invalidateTextPresentation();
    }
  }

  @Override
  public <T> T getAdapter(Class<T> type) {
    if (type != IContentOutlinePage.class) {
      return super.getAdapter(type);
    }
    if (outline == null || outline.getControl() != null && outline.getControl().isDisposed()) {
      outline = new CodeOutline(this::entries, this::show);
    }
    return type.cast(outline);
  }

  private List<Outlines.Entry> entries() {
    IDocument document = document();
    String text = document == null ? "" : document.get();
    return language == Language.OCL ? Outlines.constraints(text) : Outlines.templates(text);
  }

  private void show(Outlines.Entry entry) {
    selectAndReveal(entry.start(), entry.end() - entry.start());
  }

  @Override
  public void dispose() {
    CodeColors.forget(colors);
    IDocument document = document();
    if (document != null) {
      document.removeDocumentListener(changes);
    }
    super.dispose();
  }
}
