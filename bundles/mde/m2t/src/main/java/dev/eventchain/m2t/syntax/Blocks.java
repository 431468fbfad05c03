package dev.eventchain.m2t.syntax;

import dev.eventchain.m2t.syntax.Token.Kind;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Balancer of block tags. Unmatched tags are reported and dropped; unclosed blocks are reported and
 * closed by the enclosing block, so that the rest can be checked.
 */
final class Blocks {
  /** Greatest nesting depth; only malicious templates have deeper blocks. */
  static final int DEEPEST = 200;

  private static final Map<String, String> MIDDLE_OF = Map.of("elseif", "if", "elselet", "let");

  private final Problems problems;
  private final List<Token> tokens = new ArrayList<>();
  private final Deque<Token> open = new ArrayDeque<>();

  private Blocks(Problems problems) {
    this.problems = problems;
  }

  /** Returns the tokens with every block closed properly. */
  static List<Token> balanced(List<Token> tokens, Problems problems) {
    Blocks blocks = new Blocks(problems);
    boolean tooDeep = false;
    for (Token token : tokens) {
      if (blocks.open.size() >= DEEPEST && token.kind() == Kind.OPEN) {
        if (!tooDeep) {
          problems.add(
              SyntaxRules.NESTING,
              token.start(),
              "Blocks are nested more than " + DEEPEST + " deep.",
              "Move inner blocks into templates of their own.");
        }
        tooDeep = true;
      }
      if (!tooDeep) {
        blocks.add(token);
      }
    }
    if (!tooDeep) {
      blocks.closeAll(problems.source().text().length());
    } else {
      blocks.tokens.removeIf(token -> token.kind() != Kind.DECLARATION);
    }
    return List.copyOf(blocks.tokens);
  }

  private void add(Token token) {
    switch (token.kind()) {
      case OPEN -> open(token);
      case MIDDLE -> middle(token);
      case CLOSE -> close(token);
      case DECLARATION -> {
        closeAll(token.start());
        tokens.add(token);
      }
      default -> tokens.add(token);
    }
  }

  private void open(Token token) {
    if (token.keyword().equals("template") || token.keyword().equals("macro")) {
      closeAll(token.start());
    } else if (open.isEmpty()) {
      problems.syntax(
          token.start(),
          "A '" + token.keyword() + "' block is outside any template.",
          "Put it between [template ...] and [/template].");
      return;
    }
    open.push(token);
    tokens.add(token);
  }

  private void middle(Token token) {
    String keyword = token.keyword();
    String around = open.isEmpty() ? "" : open.peek().keyword();
    boolean fits =
        keyword.equals("else")
            ? around.equals("if") || around.equals("let")
            : around.equals(MIDDLE_OF.get(keyword));
    if (fits) {
      tokens.add(token);
    } else {
      problems.syntax(
          token.start(),
          "An '" + keyword + "' is outside the block it belongs to.",
          hintOf(keyword, around));
    }
  }

  private String hintOf(String keyword, String around) {
    Set<String> owners =
        keyword.equals("else") ? Set.of("if", "let") : Set.of(MIDDLE_OF.get(keyword));
    boolean isInOne = open.stream().anyMatch(outer -> owners.contains(outer.keyword()));
    String places =
        owners.stream()
            .sorted()
            .map(owner -> "[" + owner + " ...] and [/" + owner + "]")
            .collect(Collectors.joining(", or "));
    return isInOne
        ? "Close the block '" + around + "' before it."
        : "It belongs between " + places + ".";
  }

  private void close(Token token) {
    boolean opened = open.stream().anyMatch(o -> o.keyword().equals(token.keyword()));
    if (!opened) {
      problems.syntax(
          token.start(), "There is no block '" + token.keyword() + "' to close here.", "");
      return;
    }
    while (!open.peek().keyword().equals(token.keyword())) {
      closeMissing(token.start());
    }
    open.pop();
    tokens.add(token);
  }

  private void closeAll(int offset) {
    while (!open.isEmpty()) {
      closeMissing(offset);
    }
  }

  private void closeMissing(int offset) {
    Token opener = open.pop();
    problems.syntax(
        opener.start(),
        "The '" + opener.keyword() + "' block is not closed.",
        "Write [/"
            + opener.keyword()
            + "] before line "
            + problems.source().at(offset).line()
            + ", column "
            + problems.source().at(offset).column()
            + ".");
    tokens.add(new Token(Kind.CLOSE, opener.keyword(), offset, offset, offset, offset));
  }
}
