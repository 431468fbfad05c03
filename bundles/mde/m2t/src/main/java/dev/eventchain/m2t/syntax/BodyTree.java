package dev.eventchain.m2t.syntax;

import dev.eventchain.m2t.syntax.Token.Kind;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.List;

/** The tokens of a template as a tree: blocks have bodies, and bodies have parts. */
final class BodyTree {

  /**
   * Text and tags between two tags of a block. The first body of a block with alternatives counts
   * as long as the whole block, a later one from its own tag to the next.
   */
  static final class Body {
    private final String source;
    private final Token begin;
    private final List<Part> parts = new ArrayList<>();
    private int end;

    private Body(String source, Token begin) {
      this.source = source;
      this.begin = begin;
      this.end = source.length();
    }

    /** Returns the parts in their order. */
    List<Part> parts() {
      return Collections.unmodifiableList(parts);
    }

    /** Returns whether it is outside of any block. */
    boolean isModule() {
      return begin.kind() != Kind.OPEN && begin.kind() != Kind.MIDDLE;
    }

    boolean isTemplate() {
      return begin.kind() == Kind.OPEN && begin.keyword().equals("template");
    }

    boolean isArea() {
      return begin.kind() == Kind.OPEN && begin.keyword().equals("protected");
    }

    boolean isOnOneLine() {
      return BodyTree.isOnOneLine(source, begin.start(), end);
    }
  }

  /**
   * A text, a tag that stands alone, or a block.
   *
   * @param body the first body of a block; null for others
   * @param token the index of its (first) token
   */
  record Part(String source, Token first, int token, Body body) {
    int start() {
      return first.start();
    }

    boolean isText() {
      return first.kind() == Kind.TEXT;
    }

    boolean isComment() {
      return first.kind() == Kind.COMMENT;
    }

    boolean isBlock() {
      return body != null;
    }

    boolean isArea() {
      return isBlock() && body.isArea();
    }

    /** Returns the characters of a text. */
    String text() {
      return source.substring(first.start(), first.end());
    }

    boolean isOnOneLine() {
      return switch (first.kind()) {
        case TEXT -> text().indexOf('\n') < 0 && text().indexOf('\r') < 0;
        case EXPRESSION -> BodyTree.isOnOneLine(source, first.contentStart(), first.contentEnd());
        case OPEN -> body.isOnOneLine();
        default -> BodyTree.isOnOneLine(source, first.start(), first.end());
      };
    }
  }

  private final List<Body> bodies = new ArrayList<>();

  private BodyTree() {}

  /** Returns the tree of balanced tokens. */
  static BodyTree of(String source, List<Token> tokens) {
    BodyTree tree = new BodyTree();
    Deque<Body> blocks = new ArrayDeque<>();
    Deque<Body> open = new ArrayDeque<>();
    open.push(tree.begin(source, Token.text(0, 0)));
    for (int i = 0; i < tokens.size(); i++) {
      Token token = tokens.get(i);
      boolean inBlock = !blocks.isEmpty();
      if (token.kind() == Kind.OPEN) {
        Body body = tree.begin(source, token);
        open.element().parts.add(new Part(source, token, i, body));
        blocks.push(body);
        open.push(body);
      } else if (token.kind() == Kind.MIDDLE && inBlock) {
        open.pop().end = token.start();
        open.push(tree.begin(source, token));
      } else if (token.kind() == Kind.CLOSE && inBlock) {
        open.pop().end = token.start();
        blocks.pop().end = token.end();
      } else {
        open.element().parts.add(new Part(source, token, i, null));
      }
    }
    return tree;
  }

  private Body begin(String source, Token begin) {
    Body body = new Body(source, begin);
    bodies.add(body);
    return body;
  }

  /** Returns all bodies, outer ones first. */
  List<Body> bodies() {
    return Collections.unmodifiableList(bodies);
  }

  /** Returns whether the first and the last character of a range are on the same line. */
  private static boolean isOnOneLine(String source, int start, int end) {
    int line = source.indexOf('\n', start);
    return line < 0 || line >= end - 1;
  }
}
