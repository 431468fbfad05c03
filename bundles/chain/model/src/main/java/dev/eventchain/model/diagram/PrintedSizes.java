package dev.eventchain.model.diagram;

/**
 * Text sizes without a screen: the widths of Helvetica, which renderers stretch other fonts to. The
 * same text has the same size on every machine.
 */
public final class PrintedSizes implements TextSizes {

  /** Line heights; three quarters of them are font sizes. */
  private static final int TITLE_HEIGHT = 19;

  private static final int HEIGHT = 16;

  /** Width of bold letters relative to regular ones. */
  private static final double BOLD = 1.08;

  /** Widths of the characters from the space to the tilde, in thousandths of the font size. */
  private static final int[] WIDTHS = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584
  };

  /** Width of other letters, and of those of East Asia and pictures. */
  private static final int OTHER = 600;

  private static final int WIDE = 1000;
  private static final int FIRST_WIDE = 0x1100;

  @Override
  public int width(String text, boolean title) {
    long thousandths = text.codePoints().mapToLong(PrintedSizes::width).sum();
    double bold = title ? BOLD : 1.0;
    return (int) Math.ceil(thousandths * Shapes.fontSize(height(title)) * bold / 1000);
  }

  private static int width(int character) {
    if (character >= ' ' && character - ' ' < WIDTHS.length) {
      return WIDTHS[character - ' '];
    }
    return character < FIRST_WIDE ? OTHER : WIDE;
  }

  @Override
  public int height(boolean title) {
    return title ? TITLE_HEIGHT : HEIGHT;
  }
}
