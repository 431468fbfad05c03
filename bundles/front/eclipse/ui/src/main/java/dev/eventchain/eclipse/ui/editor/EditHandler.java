package dev.eventchain.eclipse.ui.editor;

import java.util.function.BooleanSupplier;
import org.eclipse.core.commands.AbstractHandler;
import org.eclipse.core.commands.ExecutionEvent;
import org.eclipse.core.commands.HandlerEvent;

/** A workbench command, such as undo, on the chain of an editor. */
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

  /** Notifies listeners of a change of the enabled state. */
  void update() {
    fireHandlerChanged(new HandlerEvent(this, true, false));
  }
}
