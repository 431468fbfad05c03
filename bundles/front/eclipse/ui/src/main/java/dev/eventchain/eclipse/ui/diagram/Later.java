package dev.eventchain.eclipse.ui.diagram;

import java.util.concurrent.atomic.AtomicBoolean;
import org.eclipse.swt.SWTException;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;

/**
 * Does something a little later in the user interface's thread: once, however often it is asked.
 */
final class Later {

  private static final int MILLISECONDS = 100;

  private final Control control;
  private final Display display;
  private final Runnable work;
  private final AtomicBoolean isAsked = new AtomicBoolean();

  /**
   * Work to be done later.
   *
   * @param control nothing is done once it is disposed
   */
  Later(Control control, Runnable work) {
    this.control = control;
    this.work = work;
    display = control.getDisplay();
  }

  /** Asks for the work, from any thread. */
  void ask() {
    if (isAsked.compareAndSet(false, true)) {
      inDisplay(() -> display.timerExec(MILLISECONDS, this::run));
    }
  }

  /** Does something in the user interface's thread soon, if there still is something to show. */
  void inDisplay(Runnable soon) {
    try {
      display.asyncExec(
          () -> {
            if (!control.isDisposed()) {
              soon.run();
            }
          });
    } catch (SWTException e) {
      isAsked.set(false); // the workbench is closing, and there is nobody to show anything to
    }
  }

  private void run() {
    isAsked.set(false);
    if (!control.isDisposed()) {
      work.run();
    }
  }
}
