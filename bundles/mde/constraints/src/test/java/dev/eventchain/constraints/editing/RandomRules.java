package dev.eventchain.constraints.editing;

import java.util.List;
import java.util.Random;

/** Documents of any expressions, with any white space and comments between their symbols. */
final class RandomRules {

  private static final int DEEPEST = 4;

  private static final List<String> GAPS =
      List.of("", " ", " ", "  ", "\t", "\n", "\r\n    ", "\n\n  ", " -- why\n", " /* a\n  b */ ");

  private static final List<String> OPERATORS =
      List.of("=", "<>", "<=", ">=", "<", ">", "+", "-", "*", "/", "and", "or", "xor", "implies");

  private final Random random;
  private final StringBuilder text = new StringBuilder();

  RandomRules(Random random) {
    this.random = random;
  }

  /** Returns a document. */
  String document() {
    for (int i = random.nextInt(3); i >= 0; i--) {
      add("context");
      add("Book");
      for (int j = random.nextInt(3); j >= 0; j--) {
        clause();
      }
    }
    return text.toString();
  }

  private void clause() {
    if (random.nextBoolean()) {
      all("inv", "A" + random.nextInt(9), ":");
    } else {
      all("def", ":", "a", "(", "b", ":", "Set", "(", "Integer", ")", ")", ":", "Real", "=");
    }
    expression(0);
  }

  private void all(String... symbols) {
    List.of(symbols).forEach(this::add);
  }

  /** Adds a symbol; only where two could be read as one, there is always something between. */
  private void add(String symbol) {
    String gap = GAPS.get(random.nextInt(GAPS.size()));
    char last = text.isEmpty() ? ' ' : text.charAt(text.length() - 1);
    boolean isWord = Character.isJavaIdentifierPart(symbol.charAt(0));
    boolean joins = isWord ? Character.isJavaIdentifierPart(last) : "<>-=.:".indexOf(last) >= 0;
    text.append(gap.isEmpty() && joins ? " " : gap).append(symbol);
  }

  private void expression(int depth) {
    switch (depth > DEEPEST ? random.nextInt(4) : random.nextInt(12)) {
      case 0 -> add("self");
      case 1 -> add(String.valueOf(random.nextInt(99)));
      case 2 -> add("1.5e-3");
      case 3 -> add("'a  -- \\' b'");
      case 4, 5, 6 -> {
        expression(depth + 1);
        add(OPERATORS.get(random.nextInt(OPERATORS.size())));
        expression(depth + 1);
      }
      case 7 -> {
        add(random.nextBoolean() ? "not" : "-");
        inParentheses(depth);
      }
      case 8 -> conditional(depth);
      case 9 -> {
        all("(", "let", "x", ":", "Real", "=");
        expression(depth + 1);
        add("in");
        expression(depth + 1);
        add(")");
      }
      case 10 -> {
        all("Sequence", "{");
        expression(depth + 1);
        add(",");
        expression(depth + 1);
        all("}", "->", "exists", "(", "y", "|");
        expression(depth + 1);
        add(")");
      }
      default -> {
        inParentheses(depth);
        all(random.nextBoolean() ? "." : "->", "size", "(", ")");
      }
    }
  }

  private void inParentheses(int depth) {
    add("(");
    expression(depth + 1);
    add(")");
  }

  private void conditional(int depth) {
    add("if");
    expression(depth + 1);
    add("then");
    expression(depth + 1);
    if (random.nextBoolean()) {
      add("elseif");
      expression(depth + 1);
      add("then");
      expression(depth + 1);
    }
    add("else");
    expression(depth + 1);
    add("endif");
  }
}
