package dev.eventchain.eclipse.ui.diagram;

import java.util.function.Consumer;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.Adapters;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.jface.viewers.ISelection;
import org.eclipse.jface.viewers.IStructuredSelection;
import org.eclipse.ui.IEditorPart;
import org.eclipse.ui.IPartListener2;
import org.eclipse.ui.IPropertyListener;
import org.eclipse.ui.ISelectionListener;
import org.eclipse.ui.IWorkbenchPage;
import org.eclipse.ui.IWorkbenchPart;
import org.eclipse.ui.IWorkbenchPartReference;

/** Tracks the active editor and the selected file of a page. */
final class ChainTracker implements IPartListener2, ISelectionListener, IPropertyListener {

  /** A listener, called on the user interface's thread. */
  interface Listener {
    /** Called when another chain becomes the subject. */
    void subject(Subject subject);

    /** Called when the editor of the same chain may have a new object for it. */
    void maybeOther();

    /** Called when an element is selected in the editor of the chain. */
    void element(EObject element);
  }

  private final IWorkbenchPage page;
  private final IWorkbenchPart view;
  private final Listener listener;
  private Subject subject;
  private boolean isLinked = true;

  ChainTracker(IWorkbenchPage page, IWorkbenchPart view, Listener listener) {
    this.page = page;
    this.view = view;
    this.listener = listener;
  }

  void start() {
    page.addPartListener(this);
    page.addSelectionListener(this);
    follow();
  }

  void stop() {
    page.removePartListener(this);
    page.removeSelectionListener(this);
    forgetEditor();
  }

  /** Sets whether the view follows the active editor to other chains. */
  void setLinked(boolean linked) {
    isLinked = linked;
    if (linked) {
      follow();
    }
  }

  private void follow() {
    IEditorPart editor = page.getActiveEditor();
    if (editor != null && Subject.of(editor).isPresent()) {
      Subject.of(editor).ifPresent(this::set);
    } else {
      forFile(page.getSelection(), file -> set(Subject.of(file, page)));
    }
  }

  /** Switches to a file, linked or not. */
  void turnTo(IFile file) {
    set(Subject.of(file, page));
  }

  /** Returns whether an editor has the chain of a file in memory. */
  boolean hasEditor(IFile file) {
    return Subject.of(file, page).editor() != null;
  }

  private void set(Subject next) {
    if (!next.equals(subject)) {
      forgetEditor();
      subject = next;
      if (next.editor() != null) {
        next.editor().addPropertyListener(this);
      }
      listener.subject(next);
    }
  }

  private void forgetEditor() {
    if (subject != null && subject.editor() != null) {
      subject.editor().removePropertyListener(this);
    }
  }

  /** Passes on the file that is selected or that a selected element stands for. */
  static void forFile(ISelection selection, Consumer<IFile> action) {
    if (selection instanceof IStructuredSelection structured && structured.size() == 1) {
      IFile file = Adapters.adapt(structured.getFirstElement(), IFile.class);
      if (file != null && Subject.isModel(file)) {
        action.accept(file);
      }
    }
  }

  @Override
  public void selectionChanged(IWorkbenchPart part, ISelection selection) {
    if (part == view || !isLinked) {
      return;
    }
    boolean isOwnEditor = subject != null && part == subject.editor();
    if (isOwnEditor
        && selection instanceof IStructuredSelection structured
        && structured.getFirstElement() instanceof EObject element) {
      listener.element(element);
    } else if (!(part instanceof IEditorPart)) {
      forFile(selection, file -> set(Subject.of(file, page)));
    }
  }

  @Override
  public void partActivated(IWorkbenchPartReference reference) {
    if (isLinked && reference.getPart(false) instanceof IEditorPart editor) {
      Subject.of(editor).ifPresent(this::set);
    }
  }

  @Override
  public void partBroughtToTop(IWorkbenchPartReference reference) {
    partActivated(reference);
  }

  @Override
  public void partOpened(IWorkbenchPartReference reference) {
    boolean isOfSubject =
        subject != null
            && subject.file() != null
            && reference.getPart(false) instanceof IEditorPart editor
            && Subject.of(editor).filter(s -> subject.file().equals(s.file())).isPresent();
    if (isOfSubject) {
      turnTo(subject.file());
    }
  }

  @Override
  public void partClosed(IWorkbenchPartReference reference) {
    if (subject != null
        && subject.editor() != null
        && reference.getPart(false) == subject.editor()) {
      set(new Subject(null, subject.file()));
    }
  }

  @Override
  public void propertyChanged(Object source, int property) {
    listener.maybeOther();
  }
}
