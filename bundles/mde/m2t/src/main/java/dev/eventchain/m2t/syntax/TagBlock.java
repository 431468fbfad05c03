package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.syntax.Token.Kind;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * A declaration or a block as its tags tell, whatever is wrong in them; a block without a last tag
 * ends where the one around it ends.
 *
 * @param open its first tag
 * @param middles its tags such as {@code [else]}
 * @param close its last tag, which may be empty; the first one if it has only one
 */
public record TagBlock(Token open, List<Token> middles, Token close, List<TagBlock> children) {

  /** Returns the outermost blocks and the declarations of a text, in its order. */
  public static List<TagBlock> of(SourceText source) {
    Problems lost = Problems.ignored(source);
    Deque<TagBlock> around = new ArrayDeque<>();
    List<TagBlock> outermost = new ArrayList<>();
    for (Token token : Blocks.balanced(TemplateLexer.tokens(lost), lost)) {
      List<TagBlock> siblings = around.isEmpty() ? outermost : around.peek().children();
      switch (token.kind()) {
        case DECLARATION ->
            siblings.add(new TagBlock(token, new ArrayList<>(), token, new ArrayList<>()));
        case OPEN -> around.push(new TagBlock(token, new ArrayList<>(), token, new ArrayList<>()));
        case MIDDLE -> around.peek().middles().add(token);
        case CLOSE -> {
          TagBlock block = around.pop();
          (around.isEmpty() ? outermost : around.peek().children())
              .add(new TagBlock(block.open(), block.middles(), token, block.children()));
        }
        default -> {}
      }
    }
    return outermost;
  }

  /** Returns all tags, comments and texts of a text, in its order. */
  public static List<Token> tokens(SourceText source) {
    return TemplateLexer.tokens(Problems.ignored(source));
  }

  /**
   * As {@link #tokens(SourceText)}, with each block closed; reports what is wrong with the tags.
   */
  public static List<Token> tokens(SourceText source, List<Diagnostic> problems) {
    Problems all = new Problems(source, problems);
    return Blocks.balanced(TemplateLexer.tokens(all), all);
  }

  /** Returns the offset of its first character. */
  public int start() {
    return open.start();
  }

  /** Returns the offset after its last character. */
  public int end() {
    return close.end();
  }

  /** Returns whether an offset is after its first tag and before its last one. */
  public boolean isAround(int offset) {
    return open.kind() == Kind.OPEN && open.end() <= offset && offset <= close.start();
  }
}
