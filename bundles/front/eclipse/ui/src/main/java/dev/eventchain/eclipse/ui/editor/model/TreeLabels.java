package dev.eventchain.eclipse.ui.editor.model;

import dev.eventchain.diagnostics.Severity;
import org.eclipse.jface.resource.ImageDescriptor;
import org.eclipse.jface.resource.JFaceResources;
import org.eclipse.jface.resource.LocalResourceManager;
import org.eclipse.jface.resource.ResourceManager;
import org.eclipse.jface.viewers.ColumnViewer;
import org.eclipse.jface.viewers.ColumnViewerToolTipSupport;
import org.eclipse.jface.viewers.DecorationOverlayIcon;
import org.eclipse.jface.viewers.IDecoration;
import org.eclipse.jface.viewers.StyledCellLabelProvider;
import org.eclipse.jface.viewers.StyledString;
import org.eclipse.jface.viewers.ViewerCell;
import org.eclipse.swt.graphics.Image;
import org.eclipse.ui.ISharedImages;
import org.eclipse.ui.PlatformUI;

/** Draws the elements of the tree and their findings. */
public final class TreeLabels extends StyledCellLabelProvider {

  /** Findings about the elements of the tree. */
  public interface Findings {

    /**
     * Returns the worst severity of an element and its descendants; null if there are no findings.
     */
    Severity worst(Object element);

    /** Returns the findings about the element itself as a tooltip; null if there are none. */
    String text(Object element);
  }

  private final Findings findings;
  private final ResourceManager images = new LocalResourceManager(JFaceResources.getResources());

  public TreeLabels(Findings findings) {
    this.findings = findings;
  }

  /** Shows the findings as tooltips of a tree. */
  public static void addTooltips(ColumnViewer viewer) {
    ColumnViewerToolTipSupport.enableFor(viewer);
  }

  @Override
  public void update(ViewerCell cell) {
    Labels.Label label = Labels.of(cell.getElement());
    StyledString text = new StyledString(label.name());
    if (!label.details().isEmpty()) {
      text.append("  " + label.details(), StyledString.DECORATIONS_STYLER);
    }
    cell.setText(text.getString());
    cell.setStyleRanges(text.getStyleRanges());
    cell.setImage(image(cell.getElement()));
    super.update(cell);
  }

  /** Returns the icon of an element, decorated with its findings. */
  Image image(Object element) {
    ImageDescriptor icon = Icon.of(element).descriptor();
    Severity worst = findings.worst(element);
    return worst == null || worst == Severity.INFO
        ? images.create(icon)
        : images.create(new DecorationOverlayIcon(icon, overlay(worst), IDecoration.BOTTOM_LEFT));
  }

  private static ImageDescriptor overlay(Severity severity) {
    String name =
        severity == Severity.ERROR
            ? ISharedImages.IMG_DEC_FIELD_ERROR
            : ISharedImages.IMG_DEC_FIELD_WARNING;
    return PlatformUI.getWorkbench().getSharedImages().getImageDescriptor(name);
  }

  @Override
  public String getToolTipText(Object element) {
    return findings.text(element);
  }

  @Override
  public void dispose() {
    images.dispose();
    super.dispose();
  }
}
