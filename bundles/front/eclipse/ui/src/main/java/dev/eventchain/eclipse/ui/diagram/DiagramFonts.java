package dev.eventchain.eclipse.ui.diagram;

import dev.eventchain.model.diagram.TextSizes;
import org.eclipse.jface.resource.JFaceResources;
import org.eclipse.swt.graphics.Font;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Display;

/** Fonts of the diagram: those of the workbench. For the user interface's thread. */
final class DiagramFonts implements TextSizes, AutoCloseable {

  private final GC gc;

  DiagramFonts(Display display) {
    gc = new GC(display);
  }

  static Font font(boolean title) {
    return title
        ? JFaceResources.getFontRegistry().getBold(JFaceResources.DEFAULT_FONT)
        : JFaceResources.getDefaultFont();
  }

  @Override
  public int width(String text, boolean title) {
    return size(text, title).x;
  }

  @Override
  public int height(boolean title) {
    return size("X", title).y;
  }

  private Point size(String text, boolean title) {
    gc.setFont(font(title));
    return gc.textExtent(text);
  }

  @Override
  public void close() {
    gc.dispose();
  }
}
