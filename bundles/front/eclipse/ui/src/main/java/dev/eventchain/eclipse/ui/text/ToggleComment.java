package dev.eventchain.eclipse.ui.text;

import java.util.stream.Collectors;
import org.eclipse.core.commands.AbstractHandler;
import org.eclipse.core.commands.ExecutionEvent;
import org.eclipse.core.commands.ExecutionException;
import org.eclipse.jface.text.BadLocationException;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.ITextSelection;
import org.eclipse.ui.handlers.HandlerUtil;

/** Comments or uncomments the selected lines. */
public final class ToggleComment extends AbstractHandler {

  private static final String LINE = "-- ";
  private static final String OPEN = "[comment]";
  private static final String CLOSE = "[/comment]";

  @Override
  public Object execute(ExecutionEvent event) throws ExecutionException {
    if (HandlerUtil.getActiveEditor(event) instanceof CodeEditor editor
        && editor.validateEditorInputState()
        && editor.getSelectionProvider().getSelection() instanceof ITextSelection selection) {
      IDocument document = editor.getDocumentProvider().getDocument(editor.getEditorInput());
      try {
        toggle(editor, document, selection);
      } catch (BadLocationException e) {
        throw new ExecutionException("The selection is outside of the text.", e);
      }
    }
    return null; // the required result of a handler
  }

  private static void toggle(CodeEditor editor, IDocument document, ITextSelection selection)
      throws BadLocationException {
    int first = selection.getStartLine();
    int last = selection.getEndLine();
    boolean behind =
        last > first
            && selection.getOffset() + selection.getLength() == document.getLineOffset(last);
    last = behind ? last - 1 : last; // a selection of whole lines ends at the start of the next one
    int start = document.getLineOffset(first);
    int end = document.getLineInformation(last).getOffset();
    end += document.getLineInformation(last).getLength();
    String before = document.get(start, end - start);
    String after = editor.language() == Language.OCL ? lines(before) : block(before);
    document.replace(start, end - start, after);
    int moved = after.length() - before.length();
    boolean many = selection.getLength() > 0;
    int caret = Math.max(start, selection.getOffset() + (many ? 0 : moved));
    editor.selectAndReveal(
        many ? start : Math.min(caret, start + after.length()), many ? after.length() : 0);
  }

  /** Comments every line that is not blank, or uncomments all if all are comments. */
  private static String lines(String text) {
    boolean all = text.lines().allMatch(line -> line.isBlank() || line.strip().startsWith("--"));
    String[] lines = text.split("(?<=\n)", -1);
    return java.util.Arrays.stream(lines)
        .map(line -> line.isBlank() ? line : all ? uncommented(line) : LINE + line)
        .collect(Collectors.joining());
  }

  private static String uncommented(String line) {
    int dashes = line.indexOf("--");
    int end = line.startsWith(LINE, dashes) ? dashes + LINE.length() : dashes + 2;
    return line.substring(0, dashes) + line.substring(end);
  }

  private static String block(String text) {
    String inner = text.strip();
    if (inner.startsWith(OPEN) && inner.endsWith(CLOSE)) {
      int start = text.indexOf(OPEN);
      int end = text.lastIndexOf(CLOSE);
      return text.substring(0, start)
          + text.substring(start + OPEN.length(), end)
          + text.substring(end + CLOSE.length());
    }
    return OPEN + text + CLOSE;
  }
}
