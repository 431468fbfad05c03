package dev.eventchain.eclipse.diagram;

/** How large texts are where the picture is drawn, in the picture's unit: pixels at 100 %. */
public interface TextSizes {

  /**
   * The width of a text of one line.
   *
   * @param title whether it is written in the font of names
   */
  int width(String text, boolean title);

  /** The height of a line. */
  int height(boolean title);
}
