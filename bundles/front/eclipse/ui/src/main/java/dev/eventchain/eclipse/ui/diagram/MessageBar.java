package dev.eventchain.eclipse.ui.diagram;

import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Label;
import org.eclipse.ui.ISharedImages;
import org.eclipse.ui.PlatformUI;

/** A line above the diagram, hidden without a message. */
final class MessageBar {

  static final String INFORMATION = ISharedImages.IMG_OBJS_INFO_TSK;
  static final String ERROR = ISharedImages.IMG_OBJS_ERROR_TSK;

  private final Composite bar;
  private final Label sign;
  private final Label text;

  MessageBar(Composite parent) {
    bar = new Composite(parent, SWT.NONE);
    bar.setLayout(new GridLayout(2, false));
    bar.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    sign = new Label(bar, SWT.NONE);
    sign.setLayoutData(new GridData(SWT.LEFT, SWT.TOP, false, false));
    text = new Label(bar, SWT.WRAP);
    text.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
  }

  /**
   * Shows a message.
   *
   * @param message the message; empty to hide the line
   */
  void show(String kind, String message) {
    sign.setImage(PlatformUI.getWorkbench().getSharedImages().getImage(kind));
    text.setText(message.replace("&", "&&"));
    bar.setVisible(!message.isEmpty());
    ((GridData) bar.getLayoutData()).exclude = message.isEmpty();
    bar.getParent().layout(true, true);
  }
}
