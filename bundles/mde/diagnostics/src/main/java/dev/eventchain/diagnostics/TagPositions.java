package dev.eventchain.diagnostics;

/**
 * Offsets of the start tags of a well-formed text, one after the other. Java's parser gives the end
 * of a tag only, which may be lines behind its start.
 */
final class TagPositions {

  private final String text;
  private int at = -1;

  TagPositions(String text) {
    this.text = text;
  }

  /** Returns the offset of the next start tag. */
  int next() {
    for (at = text.indexOf('<', at + 1); at >= 0; at = text.indexOf('<', at + 1)) {
      if (!skipsOther() && !text.startsWith("</", at) && !text.startsWith("<!", at)) {
        return at;
      }
    }
    throw new IllegalStateException("there is no further start tag");
  }

  /** Returns the offset of the first end tag from an offset on, which is in no other tag. */
  static int endTag(String text, int from) {
    TagPositions positions = new TagPositions(text);
    positions.at = text.indexOf('<', from);
    while (positions.skipsOther() || !text.startsWith("</", positions.at)) {
      positions.at = text.indexOf('<', positions.at + 1);
    }
    return positions.at;
  }

  /** Goes to the end of a comment, a CDATA section or a processing instruction, if one is here. */
  private boolean skipsOther() {
    if (text.startsWith("<!--", at)) {
      skipTo("-->");
    } else if (text.startsWith("<![CDATA[", at)) {
      skipTo("]]>");
    } else if (text.startsWith("<?", at)) {
      skipTo("?>");
    } else {
      return false;
    }
    return true;
  }

  private void skipTo(String end) {
    int found = text.indexOf(end, at);
    at = found < 0 ? text.length() : found;
  }
}
