package dev.eventchain.eclipse.tests;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.eclipse.jface.viewers.StructuredSelection;
import org.eclipse.jface.wizard.ProgressMonitorPart;
import org.eclipse.jface.wizard.WizardDialog;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Button;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Label;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.eclipse.swt.widgets.ToolBar;
import org.eclipse.ui.IWorkbenchWizard;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.wizards.IWizardDescriptor;

/** An open wizard, used as by people. */
final class WizardBench implements AutoCloseable {

  private final IWorkbenchWizard wizard;
  private final WizardDialog dialog;

  /** Opens a registered wizard on the selection. */
  WizardBench(IWizardDescriptor descriptor, Object... selected) {
    wizard = Workbench.run(descriptor::createWizard);
    dialog =
        Workbench.run(
            () -> {
              wizard.init(PlatformUI.getWorkbench(), new StructuredSelection(selected));
              Shell window = Workbench.page().getWorkbenchWindow().getShell();
              WizardDialog opened = new WizardDialog(window, wizard);
              opened.setBlockOnOpen(false);
              opened.open();
              opened.getShell().setActive();
              return opened;
            });
    Workbench.waitUntil(
        "the wizard is active", () -> shell() == shell().getDisplay().getActiveShell());
  }

  private Shell shell() {
    return dialog.getShell();
  }

  /** Types into the field with a label. */
  void type(String label, String text) {
    Workbench.run(
        () -> {
          ((Text) behind(label)).setText(text);
          return text;
        });
  }

  String typed(String label) {
    return Workbench.run(() -> ((Text) behind(label)).getText());
  }

  /** Returns the control after a label. */
  Control behind(String label) {
    List<Control> all = all(control -> true);
    for (int i = 0; i + 1 < all.size(); i++) {
      if (all.get(i) instanceof Label found && found.getText().replace("&", "").equals(label)) {
        return all.get(i + 1);
      }
    }
    throw new AssertionError("there is no label " + label);
  }

  /** Ticks a box or presses a button. */
  void press(String label) {
    Workbench.run(
        () -> {
          Button button = button(label);
          boolean box = (button.getStyle() & SWT.CHECK) != 0;
          if (box) {
            button.setSelection(!button.getSelection());
          }
          button.notifyListeners(SWT.Selection, new Event());
          return button;
        });
  }

  Button button(String label) {
    return (Button)
        all(control -> control instanceof Button b && b.getText().replace("&", "").equals(label))
            .get(0);
  }

  boolean canFinish() {
    return Workbench.run(() -> button("Finish").isEnabled());
  }

  /** Returns the error message of the page; empty if there is none. */
  String error() {
    return Workbench.run(
        () -> {
          String error = wizard.getPages()[0].getErrorMessage();
          return error == null ? "" : error;
        });
  }

  /** Finishes the wizard and returns whether it was closed. */
  boolean finish() {
    press("Finish");
    return Workbench.run(() -> shell() == null || shell().isDisposed());
  }

  /** Finishes without waiting. */
  void begin() {
    Workbench.display()
        .asyncExec(() -> button("Finish").notifyListeners(SWT.Selection, new Event()));
  }

  /** Stops the work of {@link #begin} and waits until the page can be used again. */
  void stop() {
    Workbench.run(
        () -> {
          Composite progress = (Composite) all(each -> each instanceof ProgressMonitorPart).get(0);
          List<Control> bars = new ArrayList<>();
          collect(progress, each -> each instanceof ToolBar, bars);
          ((ToolBar) bars.get(0)).getItem(0).notifyListeners(SWT.Selection, new Event());
          return progress;
        });
    Workbench.waitUntil("the wizard takes clicks again", () -> button("Finish").isEnabled());
  }

  private List<Control> all(Predicate<Control> wanted) {
    List<Control> found = new ArrayList<>();
    collect(shell(), wanted, found);
    return found;
  }

  private static void collect(Composite parent, Predicate<Control> wanted, List<Control> found) {
    for (Control child : parent.getChildren()) {
      if (wanted.test(child)) {
        found.add(child);
      }
      if (child instanceof Composite composite) {
        collect(composite, wanted, found);
      }
    }
  }

  @Override
  public void close() {
    Workbench.run(() -> shell() == null || dialog.close());
  }
}
