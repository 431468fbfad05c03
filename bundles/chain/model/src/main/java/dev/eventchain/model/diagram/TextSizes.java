package dev.eventchain.model.diagram;

/** Measures texts in the picture's unit: pixels at 100 %. */
public interface TextSizes {

  /**
   * Returns the width of a text of one line.
   *
   * @param title true if it is written in the font of names
   */
  int width(String text, boolean title);

  /** Returns the height of a line. */
  int height(boolean title);
}
