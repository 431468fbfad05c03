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
      if (text.startsWith("<!--", at)) {
        skipTo("-->");
      } else if (text.startsWith("<![CDATA[", at)) {
        skipTo("]]>");
      } else if (text.startsWith("<?", at)) {
        skipTo("?>");
      } else if (!text.startsWith("</", at) && !text.startsWith("<!", at)) {
        return at;
      }
    }
    throw new IllegalStateException("there is no further start tag");
  }

  private void skipTo(String end) {
    int found = text.indexOf(end, at);
    at = found < 0 ? text.length() : found;
  }
}
