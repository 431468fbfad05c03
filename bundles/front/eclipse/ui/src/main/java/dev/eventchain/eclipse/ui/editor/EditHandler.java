package dev.eventchain.eclipse.ui.editor;

import java.util.function.BooleanSupplier;
import org.eclipse.core.commands.AbstractHandler;
import org.eclipse.core.commands.ExecutionEvent;
import org.eclipse.core.commands.HandlerEvent;

/** A command of the workbench, such as undo, that works on the chain of an editor. */
final class EditHandler extends AbstractHandler {

  private final Runnable work;
  private final BooleanSupplier isPossible;

  EditHandler(Runnable work, BooleanSupplier isPossible) {
    this.work = work;
    this.isPossible = isPossible;
  }

  @Override
  public boolean isEnabled() {
    return isPossible.getAsBoolean();
  }

  @Override
  public Object execute(ExecutionEvent event) {
    if (isEnabled()) {
      work.run();
    }
    return null;
  }

  /** What is possible may have changed. */
  void update() {
    fireHandlerChanged(new HandlerEvent(this, true, false));
  }
}
