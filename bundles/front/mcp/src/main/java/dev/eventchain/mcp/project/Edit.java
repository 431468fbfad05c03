package dev.eventchain.mcp.project;

/**
 * A change of a file.
 *
 * @param file the file, relative to the project
 * @param old the text that is replaced, which occurs once; empty: the whole file, or a new one
 * @param text what takes its place
 */
public record Edit(String file, String old, String text) {

  /** Returns a file's text after the change. */
  String in(String before) {
    if (old.isEmpty()) {
      return text;
    }
    int first = before.indexOf(old);
    if (first < 0) {
      throw refusal("The text that is to be replaced is not in the file.");
    }
    if (before.indexOf(old, first + 1) >= 0) {
      throw refusal("The text that is to be replaced occurs more than once.");
    }
    return before.substring(0, first) + text + before.substring(first + old.length());
  }

  private RuntimeException refusal(String message) {
    return McpRules.refusal(
        McpRules.CHANGE,
        file,
        message,
        "Give as much of the file's text, with its white space, as occurs once.");
  }
}
