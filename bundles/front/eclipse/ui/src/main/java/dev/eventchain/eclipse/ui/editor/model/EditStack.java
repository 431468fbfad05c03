package dev.eventchain.eclipse.ui.editor.model;

import java.util.Locale;
import org.eclipse.emf.common.command.AbstractCommand;
import org.eclipse.emf.common.command.BasicCommandStack;
import org.eclipse.emf.common.command.Command;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * The commands of an editor. Typing changes the model immediately and forms one command until the
 * field is left or another change follows.
 */
public final class EditStack extends BasicCommandStack {

  private Typing typing;

  /**
   * Sets an attribute during typing.
   *
   * @param value null for none
   */
  public void type(EObject element, EStructuralFeature feature, Object value) {
    boolean goesOn =
        typing != null
            && typing == getUndoCommand()
            && typing.isAbout(element, feature)
            && isSaveNeeded();
    if (goesOn) {
      typing.value = value;
      typing.redo();
      notifyListeners();
    } else {
      Typing next = new Typing(element, feature, value);
      execute(next);
      typing = next;
    }
  }

  /** Ends the current typing command; further typing starts another one. */
  public void endTyping() {
    typing = null;
  }

  @Override
  public void execute(Command command) {
    endTyping();
    super.execute(command);
  }

  @Override
  public void undo() {
    endTyping();
    super.undo();
  }

  @Override
  public void redo() {
    endTyping();
    super.redo();
  }

  private static final class Typing extends AbstractCommand {

    private final EObject element;
    private final EStructuralFeature feature;
    private final boolean wasSet;
    private final Object before;
    private Object value;

    private Typing(EObject element, EStructuralFeature feature, Object value) {
      super("change of " + Words.of(feature).toLowerCase(Locale.ROOT));
      this.element = element;
      this.feature = feature;
      this.value = value;
      wasSet = element.eIsSet(feature);
      before = element.eGet(feature);
    }

    private boolean isAbout(EObject other, EStructuralFeature otherFeature) {
      return element == other && feature == otherFeature;
    }

    @Override
    protected boolean prepare() {
      return true;
    }

    @Override
    public void execute() {
      redo();
    }

    @Override
    public void redo() {
      if (value == null) {
        element.eUnset(feature);
      } else {
        element.eSet(feature, value);
      }
    }

    @Override
    public void undo() {
      if (wasSet) {
        element.eSet(feature, before);
      } else {
        element.eUnset(feature);
      }
    }
  }
}
