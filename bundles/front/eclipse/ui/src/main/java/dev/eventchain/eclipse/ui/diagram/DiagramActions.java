package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.eclipse.ui.EventchainUi;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.eclipse.jface.action.Action;
import org.eclipse.jface.action.IAction;
import org.eclipse.jface.action.IToolBarManager;
import org.eclipse.jface.action.Separator;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.jface.resource.ImageDescriptor;
import org.eclipse.jface.resource.ResourceLocator;
import org.eclipse.swt.SWT;
import org.eclipse.swt.dnd.Clipboard;
import org.eclipse.swt.dnd.ImageTransfer;
import org.eclipse.swt.dnd.Transfer;
import org.eclipse.swt.widgets.FileDialog;
import org.eclipse.ui.IActionBars;
import org.eclipse.ui.ISharedImages;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.actions.ActionFactory;

/** The buttons and menus of the view. */
final class DiagramActions {

  private final DiagramCanvas canvas;
  private final Consumer<Boolean> link;

  DiagramActions(DiagramCanvas canvas, Consumer<Boolean> link) {
    this.canvas = canvas;
    this.link = link;
  }

  void fill(IActionBars bars) {
    IToolBarManager tools = bars.getToolBarManager();
    Action linking = linking();
    tools.add(linking);
    tools.add(new Separator());
    tools.add(action("Zoom &In", icon("zoom_in"), canvas::zoomIn));
    tools.add(action("Zoom &Out", icon("zoom_out"), canvas::zoomOut));
    tools.add(action("Zoom to &Fit", icon("zoom_fit"), canvas::zoomToFit));
    Action save = action("&Save Picture...", shared(ISharedImages.IMG_ETOOL_SAVE_EDIT), this::save);
    Action copy = action("&Copy Picture", shared(ISharedImages.IMG_TOOL_COPY), this::copy);
    bars.getMenuManager().add(save);
    bars.getMenuManager().add(copy);
    bars.getMenuManager().add(new Separator());
    bars.getMenuManager().add(action("Original Si&ze", null, canvas::zoomToOriginal));
    bars.setGlobalActionHandler(ActionFactory.COPY.getId(), copy);
    bars.updateActionBars();
  }

  private Action linking() {
    Action linking =
        new Action("&Link with Editor and Selection", IAction.AS_CHECK_BOX) {
          @Override
          public void run() {
            link.accept(isChecked());
          }
        };
    linking.setChecked(true);
    linking.setImageDescriptor(shared(ISharedImages.IMG_ELCL_SYNCED));
    return linking;
  }

  private static Action action(String text, ImageDescriptor icon, Runnable work) {
    Action action =
        new Action(text, icon) {
          @Override
          public void run() {
            work.run();
          }
        };
    action.setToolTipText(text.replace("&", "").replace("...", ""));
    return action;
  }

  private static ImageDescriptor icon(String name) {
    return ResourceLocator.imageDescriptorFromBundle(EventchainUi.ID, "icons/" + name + ".png")
        .orElseGet(ImageDescriptor::getMissingImageDescriptor);
  }

  private static ImageDescriptor shared(String name) {
    return PlatformUI.getWorkbench().getSharedImages().getImageDescriptor(name);
  }

  private void save() {
    FileDialog dialog = new FileDialog(canvas.control().getShell(), SWT.SAVE);
    dialog.setText("Save Picture");
    dialog.setFilterNames(new String[] {"Scalable picture (*.svg)", "Picture (*.png)"});
    dialog.setFilterExtensions(new String[] {"*.svg", "*.png"});
    String name = canvas.diagram().name().replaceAll("[^\\p{L}\\p{N}_-]", "_");
    dialog.setFileName((name.isEmpty() ? "event-chain" : name) + ".svg");
    dialog.setOverwrite(true);
    String chosen = dialog.open();
    if (chosen != null) {
      try {
        PictureWriter.write(canvas.diagram(), canvas.control().getDisplay(), Path.of(chosen));
      } catch (IOException e) {
        MessageDialog.openError(
            canvas.control().getShell(),
            "Save Picture",
            chosen + " cannot be written: " + SourceText.reason(e) + ".");
      }
    }
  }

  private void copy() {
    Clipboard clipboard = new Clipboard(canvas.control().getDisplay());
    clipboard.setContents(
        new Object[] {PictureWriter.image(canvas.diagram(), canvas.control().getDisplay())},
        new Transfer[] {ImageTransfer.getInstance()});
    clipboard.dispose();
  }
}
