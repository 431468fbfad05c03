package dev.eventchain.eclipse.ui.diagram;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.widgets.Control;

/** Colours of the diagram, derived from the theme's colours for lists. */
record DiagramColors(Color background, Color foreground, Color accent) {

  private static final Color ERROR = new Color(214, 48, 49);
  private static final Color WARNING = new Color(222, 150, 0);

  /** Colours of a control, which a theme may change at any time. */
  record Source(Control control) {
    DiagramColors get() {
      return new DiagramColors(
          control.getBackground(),
          control.getForeground(),
          control.getDisplay().getSystemColor(SWT.COLOR_LIST_SELECTION));
    }
  }

  /** Colours for paper. */
  static DiagramColors ofPaper(Device device) {
    return new DiagramColors(
        device.getSystemColor(SWT.COLOR_WHITE),
        device.getSystemColor(SWT.COLOR_BLACK),
        new Color(10, 88, 168));
  }

  Color line() {
    return mix(foreground, 70);
  }

  /** Returns the colour of secondary text. */
  Color facts() {
    return mix(foreground, 75);
  }

  Color component() {
    return mix(foreground, 5);
  }

  Color componentBorder() {
    return mix(foreground, 55);
  }

  Color topicBorder() {
    return mix(foreground, 38);
  }

  Color generated() {
    return mix(accent, 15);
  }

  Color selection() {
    return mix(accent, 45);
  }

  static Color error() {
    return ERROR;
  }

  static Color warning() {
    return WARNING;
  }

  /** Returns the background with some percent of another colour. */
  private Color mix(Color other, int percent) {
    RGB a = background.getRGB();
    RGB b = other.getRGB();
    return new Color(
        mix(a.red, b.red, percent), mix(a.green, b.green, percent), mix(a.blue, b.blue, percent));
  }

  private static int mix(int from, int to, int percent) {
    return (from * (100 - percent) + to * percent) / 100;
  }
}
