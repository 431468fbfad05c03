package dev.eventchain.m2t.editing;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.TextLines;
import dev.eventchain.m2t.syntax.ModuleLoader;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.m2t.syntax.TagBlock;
import dev.eventchain.m2t.syntax.TemplateLexer;
import dev.eventchain.m2t.syntax.Token;
import java.nio.file.Path;
import java.util.List;

/**
 * One version of a template file, read without metamodels.
 *
 * @param written the text as it is
 * @param source the text with a bracket in place of the line break after each tag of a block that
 *     is not closed, so that the block is known; offsets are the same
 */
record TemplateText(
    Path file,
    SourceText written,
    SourceText source,
    TextLines lines,
    List<Token> tokens,
    List<TagBlock> blocks,
    Syntax.Module module) {

  static TemplateText of(Path file, SourceText written) {
    List<Token> tokens = TagBlock.tokens(written);
    StringBuilder repaired = new StringBuilder(written.text());
    boolean changed = false;
    for (Token token : tokens) {
      int end = lineEnd(token, written.text());
      if (end >= 0) {
        repaired.setCharAt(end, ']');
        changed = true;
      }
    }
    SourceText source = changed ? SourceText.of(written.name(), repaired.toString()) : written;
    return new TemplateText(
        file,
        written,
        source,
        new TextLines(written.text()),
        tokens,
        TagBlock.of(source),
        ModuleLoader.understand(source));
  }

  /** Returns the line break after a tag that begins a block and is not closed; -1 for others. */
  private static int lineEnd(Token token, String text) {
    if (token.kind() != Token.Kind.BROKEN
        || !TemplateLexer.keywords().contains(firstWord(text, token.start()))) {
      return -1;
    }
    for (int i = token.start(); i <= token.end() && i < text.length(); i++) {
      if (text.charAt(i) == '\n' || text.charAt(i) == '\r') {
        return i;
      }
    }
    return -1;
  }

  /** Returns where the content of a tag ends. */
  int contentEnd(Token tag) {
    int line = lineEnd(tag, written.text());
    boolean closed = tag.kind() != Token.Kind.BROKEN;
    return closed ? tag.contentEnd() : line < 0 ? tag.end() : line;
  }

  private static String firstWord(String text, int start) {
    int end = start + 1;
    while (end < text.length() && Character.isJavaIdentifierPart(text.charAt(end))) {
      end++;
    }
    return text.substring(start + 1, end);
  }

  /** Returns the tag or comment that an offset is in; {@code null} in text. */
  Token tagAt(int offset) {
    for (Token token : tokens) {
      if (token.start() >= offset) {
        return null;
      }
      boolean open = token.kind() == Token.Kind.BROKEN;
      if (offset < token.end() || (open && offset == token.end())) {
        return token.kind() == Token.Kind.TEXT ? null : token;
      }
    }
    return null;
  }

  /** Returns where the first word of a tag stands, which may be misspelt. */
  SourceRange wordIn(Token tag) {
    String all = written.text();
    int start = tag.start() + 1;
    while (start < tag.end() && !Character.isJavaIdentifierPart(all.charAt(start))) {
      start++;
    }
    int end = start;
    while (end < tag.end() && Character.isJavaIdentifierPart(all.charAt(end))) {
      end++;
    }
    return written.range(start, end);
  }

  /** Returns the first word of a tag. */
  String wordOf(Token tag) {
    return firstWord(written.text(), tag.start());
  }
}
