package dev.eventchain.eclipse.ui.text;

import dev.eventchain.eclipse.ui.EventchainUi;
import dev.eventchain.editing.SemanticToken;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextPosition;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.jface.preference.IPreferenceStore;
import org.eclipse.jface.preference.PreferenceStore;
import org.eclipse.jface.text.BadLocationException;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.IRegion;
import org.eclipse.jface.text.Region;
import org.eclipse.jface.text.TextEvent;
import org.eclipse.jface.text.source.DefaultCharacterPairMatcher;
import org.eclipse.jface.text.source.ISourceViewer;
import org.eclipse.jface.text.source.IVerticalRuler;
import org.eclipse.jface.text.source.projection.ProjectionSupport;
import org.eclipse.jface.text.source.projection.ProjectionViewer;
import org.eclipse.jface.util.IPropertyChangeListener;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.ui.IEditorInput;
import org.eclipse.ui.IPathEditorInput;
import org.eclipse.ui.editors.text.EditorsUI;
import org.eclipse.ui.editors.text.TextEditor;
import org.eclipse.ui.texteditor.ChainedPreferenceStore;
import org.eclipse.ui.texteditor.SourceViewerDecorationSupport;
import org.eclipse.ui.views.contentoutline.IContentOutlinePage;

/** A text editor for a language, which shows what the analysis of its text finds. */
abstract class CodeEditor extends TextEditor {

  /** Context in which the key bindings of these editors are active. */
  static final String CONTEXT = EventchainUi.ID + ".text.context";

  private static final String BRACKETS = EventchainUi.ID + ".text.brackets";
  private static final String BRACKETS_COLOR = BRACKETS + ".color";

  private static final Set<SemanticToken.Kind> NO_NAMES =
      Set.of(
          SemanticToken.Kind.KEYWORD,
          SemanticToken.Kind.COMMENT,
          SemanticToken.Kind.STRING,
          SemanticToken.Kind.NUMBER,
          SemanticToken.Kind.OPERATOR,
          SemanticToken.Kind.ANNOTATION);

  private final Language language;
  private final IPropertyChangeListener colors = event -> draw();
  private CodeOutline outline;
  private volatile CodeText text;
  private CodeText.Known known;
  private ProjectionSupport folding;

  CodeEditor(Language language) {
    this.language = language;
  }

  final Language language() {
    return language;
  }

  /** Returns the text and what is known about it; null while nothing is open. */
  final CodeText text() {
    return text;
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
  protected void doSetInput(IEditorInput input) throws CoreException {
    closeText();
    setSourceViewerConfiguration(new CodeConfiguration(this, getPreferenceStore()));
    super.doSetInput(input);
    IDocument document = document();
    if (document != null) {
      Optional<IFile> file =
          Optional.ofNullable(input.getAdapter(IFile.class)).filter(it -> it.getLocation() != null);
      text = new CodeText(language, document, file, path(input), this::show);
    }
  }

  /** Returns the path of a file outside of Eclipse's workspace; without one, the name tells. */
  private static Path path(IEditorInput input) {
    IPathEditorInput local = input.getAdapter(IPathEditorInput.class);
    return local != null && local.getPath() != null
        ? local.getPath().toPath()
        : Path.of(input.getName()).toAbsolutePath();
  }

  private void closeText() {
    if (text != null) {
      text.close();
    }
    text = null;
    known = null;
  }

  private IDocument document() {
    return getDocumentProvider() == null
        ? null
        : getDocumentProvider().getDocument(getEditorInput());
  }

  private void show(CodeText.Known found) {
    known = found;
    draw();
    if (outline != null) {
      outline.show(found.symbols());
    }
    if (getSourceViewer() instanceof ProjectionViewer viewer
        && viewer.getProjectionAnnotationModel() != null) {
      CodeFoldings.show(
          found.foldings(), viewer.getDocument(), viewer.getProjectionAnnotationModel());
    }
  }

  private void draw() {
    ISourceViewer viewer = getSourceViewer();
    if (viewer == null || viewer.getTextWidget() == null || viewer.getTextWidget().isDisposed()) {
      return;
    }
    int length = viewer.getDocument() == null ? 0 : viewer.getDocument().getLength();
    if (known != null && known.present().text().length() == length) {
      viewer.changeTextPresentation(CodeColors.presentation(known.colors(), length), true);
    }
  }

  @Override
  protected ISourceViewer createSourceViewer(Composite parent, IVerticalRuler ruler, int styles) {
    ISourceViewer viewer =
        new ProjectionViewer(parent, ruler, getOverviewRuler(), isOverviewRulerVisible(), styles);
    getSourceViewerDecorationSupport(viewer);
    return viewer;
  }

  @Override
  protected void initializeKeyBindingScopes() {
    setKeyBindingScopes(new String[] {CONTEXT});
  }

  @Override
  public void createPartControl(Composite parent) {
    super.createPartControl(parent);
    ProjectionViewer viewer = (ProjectionViewer) getSourceViewer();
    folding = new ProjectionSupport(viewer, getAnnotationAccess(), getSharedColors());
    folding.addSummarizableAnnotationType("org.eclipse.ui.workbench.texteditor.error");
    folding.addSummarizableAnnotationType("org.eclipse.ui.workbench.texteditor.warning");
    folding.install();
    viewer.doOperation(ProjectionViewer.TOGGLE);
    viewer.addTextListener(this::shownAgain);
    CodeColors.listen(colors);
  }

  /** Draws lines that come into view without a change of the text, such as those of a folding. */
  private void shownAgain(TextEvent event) {
    if (event.getDocumentEvent() == null && event.getViewerRedrawState()) {
      draw();
    }
  }

  @Override
  protected void configureSourceViewerDecorationSupport(SourceViewerDecorationSupport support) {
    super.configureSourceViewerDecorationSupport(support);
    support.setCharacterPairMatcher(new DefaultCharacterPairMatcher("()[]{}".toCharArray()));
    support.setMatchingCharacterPainterPreferenceKeys(BRACKETS, BRACKETS_COLOR);
  }

  /** Analyses the text again: files that it uses may have changed in other editors. */
  @Override
  public void setFocus() {
    super.setFocus();
    if (text != null) {
      text.refresh();
    }
  }

  @Override
  public <T> T getAdapter(Class<T> type) {
    if (type == IContentOutlinePage.class) {
      if (outline == null || outline.getControl() != null && outline.getControl().isDisposed()) {
        outline = new CodeOutline(known == null ? List.of() : known.symbols(), this::show);
      }
      return type.cast(outline);
    }
    Object found = folding == null ? null : folding.getAdapter(getSourceViewer(), type);
    return found == null ? super.getAdapter(type) : type.cast(found);
  }

  private void show(Symbol symbol) {
    int start = text.present().lines().offset(symbol.nameRange().start());
    selectAndReveal(start, text.present().lines().offset(symbol.nameRange().end()) - start);
  }

  /** Shows a sentence in the line at the bottom of the window. */
  final void say(String sentence) {
    setStatusLineMessage(sentence);
  }

  /** Returns whether the word that begins at an offset is a name. */
  final boolean isName(int offset) {
    if (known == null) {
      return false;
    }
    TextPosition start = known.present().lines().position(offset);
    return known.tokens().stream()
        .filter(each -> each.line() == start.line() && each.column() == start.column())
        .anyMatch(each -> !NO_NAMES.contains(each.kind()));
  }

  /** Returns the word around an offset; an empty region if there is none. */
  static IRegion word(IDocument document, int offset) {
    try {
      int start = offset;
      while (start > 0 && Character.isJavaIdentifierPart(document.getChar(start - 1))) {
        start--;
      }
      int end = offset;
      while (end < document.getLength() && Character.isJavaIdentifierPart(document.getChar(end))) {
        end++;
      }
      return new Region(start, end - start);
    } catch (BadLocationException e) {
      return new Region(offset, 0); // the text has become shorter
    }
  }

  @Override
  public void dispose() {
    CodeColors.forget(colors);
    closeText();
    if (folding != null) {
      folding.dispose();
    }
    super.dispose();
  }
}
