package dev.eventchain.eclipse.ui.text;

import java.util.List;
import java.util.function.Function;
import org.eclipse.jface.text.BadLocationException;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.rules.IToken;
import org.eclipse.jface.text.rules.ITokenScanner;

/** Provides the tokens of a part of a document with their colours. */
final class CodeScanner implements ITokenScanner {

  private final Function<String, List<Token>> reader;
  private List<Token> tokens = List.of();
  private int start;
  private int next;

  /**
   * @param reader returns the tokens of a text that begins within a partition
   */
  CodeScanner(Function<String, List<Token>> reader) {
    this.reader = reader;
  }

  @Override
  public void setRange(IDocument document, int offset, int length) {
    start = offset;
    next = 0;
    try {
      tokens = reader.apply(document.get(offset, length));
    } catch (BadLocationException e) {
      tokens = List.of(); // shortened meanwhile: redrawn after that change
    }
  }

  @Override
  public IToken nextToken() {
    if (next >= tokens.size()) {
      return org.eclipse.jface.text.rules.Token.EOF;
    }
    Token token = tokens.get(next++);
    return new org.eclipse.jface.text.rules.Token(CodeColors.attribute(token.kind()));
  }

  @Override
  public int getTokenOffset() {
    return start + tokens.get(next - 1).start();
  }

  @Override
  public int getTokenLength() {
    Token token = tokens.get(next - 1);
    return token.end() - token.start();
  }
}
