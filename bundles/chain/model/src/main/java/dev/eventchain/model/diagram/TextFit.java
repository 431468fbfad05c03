package dev.eventchain.model.diagram;

import dev.eventchain.model.diagram.ChainDiagram.Text;

/** Abbreviates texts in the middle, because both ends of a long name are distinctive. */
final class TextFit {

  private static final String GAP = "\u2026";

  /** Largest number of characters shown, and so measured. */
  private static final int LONGEST = 1000;

  private final TextSizes sizes;

  TextFit(TextSizes sizes) {
    this.sizes = sizes;
  }

  /**
   * Returns the longest fitting form of a text.
   *
   * @param most the largest width
   */
  Text fit(String text, boolean title, int most) {
    int characters = text.codePointCount(0, text.length());
    if (characters > LONGEST) {
      return fit(cut(text, LONGEST - 1, characters), title, most);
    }
    int width = sizes.width(text, title);
    if (width <= most) {
      return new Text(text, width, title);
    }
    int fitting = 0;
    for (int step = Integer.highestOneBit(characters); step > 0; step /= 2) {
      int tried = fitting + step;
      if (tried < characters && sizes.width(cut(text, tried, characters), title) <= most) {
        fitting = tried;
      }
    }
    String shown = cut(text, fitting, characters);
    return new Text(shown, sizes.width(shown, title), title);
  }

  private static String cut(String text, int kept, int characters) {
    int end = text.offsetByCodePoints(0, (kept + 1) / 2);
    int start = text.offsetByCodePoints(0, characters - kept / 2);
    return text.substring(0, end) + GAP + text.substring(start);
  }
}
