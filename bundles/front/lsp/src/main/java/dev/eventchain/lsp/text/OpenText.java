package dev.eventchain.lsp.text;

import dev.eventchain.editing.TextLines;
import java.nio.file.Path;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextDocumentContentChangeEvent;

/**
 * A version of a text that is open in an editor.
 *
 * @param uri as the editor writes it
 * @param path absolute and normalized
 * @param text with its byte order mark, if the editor has kept it
 */
public record OpenText(String uri, Path path, int version, String text) {

  private static final char BYTE_ORDER_MARK = '\uFEFF';

  /** Returns the text after a change of a part or of all of it. */
  OpenText with(int newVersion, TextDocumentContentChangeEvent change) {
    Range range = change.getRange();
    if (range == null) {
      return new OpenText(uri, path, newVersion, change.getText());
    }
    TextLines lines = new TextLines(text);
    int start = lines.offset(Positions.of(range.getStart()));
    int end = Math.max(start, lines.offset(Positions.of(range.getEnd())));
    return new OpenText(
        uri, path, newVersion, text.substring(0, start) + change.getText() + text.substring(end));
  }

  /** Returns whether columns of the first line are one less in the engine, which skips the mark. */
  public boolean hasMark() {
    return !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK;
  }

  /** Returns the text as the engine reads it. */
  public String withoutMark() {
    return hasMark() ? text.substring(1) : text;
  }
}
