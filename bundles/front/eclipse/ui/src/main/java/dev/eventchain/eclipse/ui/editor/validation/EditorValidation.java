package dev.eventchain.eclipse.ui.editor.validation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.eclipse.ChainFindings;
import dev.eventchain.model.eventchain.EventChain;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.Status;
import org.eclipse.core.runtime.jobs.Job;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.swt.widgets.Display;

/** Checks a copy of the chain in the background, shortly after a change. */
public final class EditorValidation {

  private static final int DELAY = 300; // ms

  private final ChainValidation validation;
  private final EventChain chain;
  private final Supplier<IFile> file;
  private final Consumer<List<ElementFinding>> result;
  private final Display display = Display.getCurrent();
  private final Runnable start = this::start;
  private Job running;
  private boolean disposed;

  /**
   * @param file the current file of the chain, which determines the applicable rules
   * @param result receives the findings on the user interface's thread
   */
  public EditorValidation(
      ChainValidation validation,
      EventChain chain,
      Supplier<IFile> file,
      Consumer<List<ElementFinding>> result) {
    this.validation = validation;
    this.chain = chain;
    this.file = file;
    this.result = result;
  }

  /** Schedules a check after a change of the chain. */
  public void schedule() {
    if (running != null) {
      running.cancel(); // its findings would be about an outdated chain
    }
    display.timerExec(DELAY, start);
  }

  /** Cancels the checks. */
  public void dispose() {
    disposed = true;
    display.timerExec(-1, start);
    if (running != null) {
      running.cancel();
    }
  }

  private void start() {
    if (running != null) {
      running.cancel();
    }
    EcoreUtil.Copier copier = new EcoreUtil.Copier();
    EventChain copy = (EventChain) copier.copy(chain);
    copier.copyReferences();
    Map<EObject, EObject> originals = new HashMap<>();
    copier.forEach((original, made) -> originals.put(made, original));
    IFile now = file.get();
    running =
        Job.create(
            "Checking " + now.getName(),
            monitor -> {
              List<ElementFinding> found = check(copy, now, monitor);
              display(() -> show(monitor, originals, found));
              return monitor.isCanceled() ? Status.CANCEL_STATUS : Status.OK_STATUS;
            });
    running.setSystem(true);
    running.setPriority(Job.DECORATE);
    running.schedule();
  }

  private void show(
      IProgressMonitor monitor, Map<EObject, EObject> originals, List<ElementFinding> found) {
    if (!disposed && !monitor.isCanceled()) {
      result.accept(
          found.stream()
              .map(finding -> finding.about(originals.getOrDefault(finding.element(), chain)))
              .toList());
    }
  }

  private void display(Runnable work) {
    if (!display.isDisposed()) {
      display.asyncExec(work);
    }
  }

  /**
   * Checks the chain and turns failures of the check into findings: an unchecked chain is never
   * shown as valid.
   */
  private List<ElementFinding> check(EventChain copy, IFile place, IProgressMonitor monitor) {
    try {
      return validation.validate(copy, place, monitor);
    } catch (RuntimeException | LinkageError | StackOverflowError e) {
      Diagnostic finding =
          ChainFindings.nothingChecked(
              "The chain was not checked: " + e.getClass().getSimpleName() + " " + e.getMessage());
      return List.of(new ElementFinding(finding, copy, null));
    }
  }
}
