package dev.eventchain.eclipse.ui.diagram;

import java.util.concurrent.atomic.AtomicBoolean;
import org.eclipse.swt.SWTException;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;

/** Runs work a little later on the user interface's thread: once for any number of requests. */
final class Later {

  private static final int MILLISECONDS = 100;

  private final Control control;
  private final Display display;
  private final Runnable work;
  private final AtomicBoolean isAsked = new AtomicBoolean();

  /**
   * Creates the delayed work.
   *
   * @param control the control, after whose disposal nothing runs
   */
  Later(Control control, Runnable work) {
    this.control = control;
    this.work = work;
    display = control.getDisplay();
  }

  /** Requests the work, from any thread. */
  void ask() {
    if (isAsked.compareAndSet(false, true)) {
      inDisplay(() -> display.timerExec(MILLISECONDS, this::run));
    }
  }

  /** Runs work soon on the user interface's thread, unless the control is disposed by then. */
  void inDisplay(Runnable soon) {
    try {
      display.asyncExec(
          () -> {
            if (!control.isDisposed()) {
              soon.run();
            }
          });
    } catch (SWTException e) {
      isAsked.set(false); // the workbench is closing, and there is nothing to show
    }
  }

  private void run() {
    isAsked.set(false);
    if (!control.isDisposed()) {
      work.run();
    }
  }
}
