package dev.eventchain.eclipse.ui.editor;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.eclipse.ui.editor.model.EditedModel;
import dev.eventchain.eclipse.ui.editor.model.Icon;
import dev.eventchain.eclipse.ui.editor.model.MarkerTarget;
import dev.eventchain.eclipse.ui.editor.model.ModelFile;
import dev.eventchain.model.eventchain.EventChain;
import java.util.Optional;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.IResourceStatus;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.NullProgressMonitor;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.edit.domain.EditingDomain;
import org.eclipse.emf.edit.domain.IEditingDomainProvider;
import org.eclipse.jface.resource.JFaceResources;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.IEditorInput;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IEditorSite;
import org.eclipse.ui.IWorkbenchPage;
import org.eclipse.ui.PartInitException;
import org.eclipse.ui.ide.IGotoMarker;
import org.eclipse.ui.ide.ResourceUtil;
import org.eclipse.ui.part.EditorPart;
import org.eclipse.ui.part.FileEditorInput;
import org.eclipse.ui.texteditor.ITextEditor;
import org.eclipse.ui.views.contentoutline.IContentOutlinePage;

/**
 * Edits an event chain as a tree with properties. It adapts to the {@link EventChain} in memory,
 * its {@link EditingDomain} and an outline; its selection consists of elements of the chain. An
 * invalid model file is shown as a list of its problems.
 */
public final class ChainEditor extends EditorPart implements IGotoMarker, IEditingDomainProvider {

  private static final String TEXT_EDITOR = "org.eclipse.ui.DefaultTextEditor";

  private final ChainSelection selection = new ChainSelection(this::select);
  private final ChainOutline outline = new ChainOutline(this::select);
  private ModelFile file;
  private FileWatch watch;
  private Composite area;
  private EditHandlers handlers;

  /** Null while the file is not a valid model. */
  private ModelPage page;

  private boolean isDeleted;
  private boolean isAsking;

  @Override
  public void init(IEditorSite site, IEditorInput input) throws PartInitException {
    IFile opened = ResourceUtil.getFile(input);
    if (opened == null) {
      throw new PartInitException(
          input.getName() + " is not in a project of the workspace. Import it into one first.");
    }
    setSite(site);
    setInput(input);
    setPartName(input.getName());
    file = new ModelFile(opened);
    site.setSelectionProvider(selection);
  }

  @Override
  public void createPartControl(Composite parent) {
    area = new Composite(parent, SWT.NONE);
    area.setLayout(new FillLayout());
    setTitleImage(JFaceResources.getResources().create(Icon.CHAIN.descriptor()));
    handlers =
        new EditHandlers(
            getEditorSite(),
            () -> page == null ? null : page.model().stack(),
            new EditHandler(this::load, this::isDirty));
    refreshFromDisk();
    watch();
    load();
  }

  private void refreshFromDisk() {
    try {
      file.file().refreshLocal(IResource.DEPTH_ZERO, new NullProgressMonitor());
    } catch (CoreException e) { // loading the file reports the problems
      setContentDescription("");
    }
  }

  private void watch() {
    watch =
        new FileWatch(
            file.file(),
            new FileWatch.Listener() {
              @Override
              public void changed() {
                fileChanged();
              }

              @Override
              public void moved(IFile to) {
                fileMoved(to);
              }

              @Override
              public void deleted() {
                fileDeleted();
              }
            });
  }

  /** Loads the file from disk, and selects the same element again. */
  private void load() {
    String selected =
        page != null && selection.first() != null ? MarkerTarget.path(selection.first()) : "";
    ModelFile.Content content = file.load();
    for (Control child : area.getChildren()) {
      child.dispose();
    }
    page = content.model().map(this::page).orElse(null);
    if (page == null) {
      new BrokenPage(area, content.problems(), this::openAsText);
    } else {
      MarkerTarget.find(page.chain(), selected).ifPresent(page::select);
    }
    isDeleted = false;
    area.layout(true);
    outline.show(page);
    changed();
  }

  private ModelPage page(EditedModel model) {
    ModelPage made = new ModelPage(area, model, getEditorSite(), selection, file);
    made.whenChanged(this::changed);
    made.whenChanged(outline::refresh);
    return made;
  }

  private void changed() {
    firePropertyChange(PROP_DIRTY);
    handlers.update();
  }

  private void openAsText(int line) {
    try {
      IEditorPart text =
          getSite()
              .getPage()
              .openEditor(
                  new FileEditorInput(file.file()),
                  TEXT_EDITOR,
                  true,
                  IWorkbenchPage.MATCH_INPUT | IWorkbenchPage.MATCH_ID);
      if (line > 0 && text instanceof ITextEditor editor) {
        TextLine.show(editor, line);
      }
    } catch (PartInitException e) {
      SaveDialogs.inform(shell(), "The file cannot be opened as text: " + e.getMessage());
    }
  }

  private void fileChanged() {
    if (area.isDisposed() || isAsking || !file.isChanged()) {
      return;
    }
    isAsking = true;
    boolean edited =
        page != null && page.model().stack().isSaveNeeded(); // also if the file was deleted
    boolean loads =
        !(edited || isDirty() && !isDeleted) || SaveDialogs.replace(shell(), file.file());
    isAsking = false;
    if (loads) {
      load();
    }
  }

  private void fileMoved(IFile to) {
    if (!area.isDisposed()) {
      becomes(to);
    }
  }

  private void becomes(IFile other) {
    watch.dispose();
    file.moveTo(other);
    watch();
    setInputWithNotify(new FileEditorInput(other));
    setPartName(other.getName());
    isDeleted = false;
    if (page != null) {
      page.recheck(); // other rules may apply there
    }
  }

  private void fileDeleted() {
    if (area.isDisposed() || file.file().exists()) {
      return;
    }
    if (page == null || !file.file().getProject().isAccessible()) {
      getSite().getPage().closeEditor(this, false);
      return;
    }
    isDeleted = true;
    page.say(
        "The file has been deleted. Save writes it again; File > Save As writes it to another"
            + " place.");
    changed();
  }

  @Override
  public boolean isDirty() {
    return page != null && (isDeleted || page.model().stack().isSaveNeeded());
  }

  @Override
  public void doSave(IProgressMonitor monitor) {
    boolean isSaved = page != null && save(monitor);
    if (!isSaved && monitor != null) {
      monitor.setCanceled(true);
    }
  }

  private boolean save(IProgressMonitor monitor) {
    IStatus mayWrite = file.mayWrite(shell());
    if (!mayWrite.isOK()) {
      return saveElsewhere(
          mayWrite.getMessage()
              + " Make the file writable in its properties, or save under another name.");
    }
    try {
      file.save(page.model().bytes(), monitor);
    } catch (DiagnosticException e) {
      String hint = e.diagnostics().get(0).hint();
      SaveDialogs.inform(shell(), e.diagnostics().get(0).message() + " " + hint);
      return false;
    } catch (CoreException e) {
      return isOutOfSync(e) ? overwrite(monitor) : saveElsewhere(e.getStatus().getMessage());
    }
    page.model().stack().saveIsDone();
    isDeleted = false;
    page.say("");
    changed();
    return true;
  }

  private static boolean isOutOfSync(CoreException e) {
    return e.getStatus().getCode() == IResourceStatus.OUT_OF_SYNC_LOCAL;
  }

  private boolean overwrite(IProgressMonitor monitor) {
    isAsking = true;
    boolean overwrites = SaveDialogs.overwrite(shell(), file.file());
    if (overwrites) {
      refreshFromDisk();
    }
    isAsking = false;
    return overwrites && save(monitor);
  }

  private boolean saveElsewhere(String reason) {
    return SaveDialogs.saveAs(shell(), file.file(), reason) && saveAs();
  }

  @Override
  public void doSaveAs() {
    saveAs();
  }

  private boolean saveAs() {
    Optional<IFile> other = SaveDialogs.chooseFile(shell(), file.file());
    if (other.isEmpty()) {
      return false;
    }
    IFile former = file.file();
    becomes(other.get());
    boolean saved = save(new NullProgressMonitor());
    if (!saved && former.exists()) {
      becomes(former);
    }
    return saved;
  }

  @Override
  public boolean isSaveAsAllowed() {
    return page != null;
  }

  private Shell shell() {
    return getSite().getShell();
  }

  @Override
  public void setFocus() {
    if (page != null) {
      page.setFocus();
    } else {
      area.setFocus();
    }
  }

  private void select(EObject element) {
    if (page != null) {
      page.select(element);
    }
  }

  @Override
  public void gotoMarker(IMarker marker) {
    if (page != null) {
      MarkerTarget.find(page.model(), marker).ifPresent(this::select);
    }
  }

  @Override
  public EditingDomain getEditingDomain() {
    return page == null ? null : page.model().domain();
  }

  @Override
  public <T> T getAdapter(Class<T> type) {
    if (type == EventChain.class) {
      return page == null ? null : type.cast(page.chain());
    } else if (type == EditingDomain.class) {
      return type.cast(getEditingDomain());
    } else if (type == IContentOutlinePage.class) {
      return type.cast(outline);
    }
    return super.getAdapter(type);
  }

  @Override
  public void dispose() {
    if (watch != null) {
      watch.dispose();
    }
    super.dispose();
  }
}
