package dev.eventchain.constraints.editing;

import dev.eventchain.ocl.text.Spacing;
import dev.eventchain.ocl.text.Symbol;
import dev.eventchain.ocl.text.Symbol.Kind;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;

/**
 * Indentation of the lines of a Complete OCL document, in steps: members of a context one, their
 * expressions two, and what continues an expression, or is inside parentheses, one more than the
 * line on which that begins.
 */
final class Indentation {

  private enum Part {
    CLAUSE,
    BRACKET,
    IF,
    LET,
    LET_BODY
  }

  /** Something that is not finished yet. */
  private static final class Open {
    private final Part part;

    /** The steps of the line on which it begins. */
    private final int base;

    /** True before the first symbol of an item or an expression. */
    private boolean begins = true;

    /** The steps of lines on which the item goes on. */
    private int further;

    Open(Part part, int base) {
      this.part = part;
      this.base = base;
      this.further = base + 1;
    }
  }

  private final List<Symbol> symbols;
  private final Headings headings;
  private final Deque<Open> open = new ArrayDeque<>();

  /** The steps of the present line. */
  private int line;

  Indentation(List<Symbol> symbols, Headings headings) {
    this.symbols = symbols;
    this.headings = headings;
  }

  /** Returns the steps of the line that a symbol begins. */
  int level(int index) {
    Symbol symbol = symbols.get(index);
    return symbol.kind() == Kind.COMMENT ? commentLevel(index) : codeLevel(index);
  }

  /** Returns the steps of what a comment is about: the next symbol. */
  private int commentLevel(int index) {
    int next = index;
    while (symbols.get(next).kind() == Kind.COMMENT) {
      next++;
    }
    Symbol symbol = symbols.get(next);
    if (symbol.kind() == Kind.END || headings.outer().contains(symbol.start())) {
      boolean outside = open.isEmpty() || isAtMargin(symbols.get(index));
      return outside ? 0 : 1;
    }
    return codeLevel(next) + (end(next) == null ? 0 : 1);
  }

  private static boolean isAtMargin(Symbol symbol) {
    return symbol.gap().isEmpty()
        || "\r\n".indexOf(symbol.gap().charAt(symbol.gap().length() - 1)) >= 0;
  }

  private int codeLevel(int index) {
    int start = symbols.get(index).start();
    if (headings.outer().contains(start) || open.isEmpty()) {
      return 0;
    } else if (headings.members().contains(start)) {
      return 1;
    }
    Part ended = end(index);
    if (ended != null) {
      return open.stream()
          .filter(each -> each.part == ended)
          .findFirst()
          .map(e -> e.base)
          .orElse(0);
    }
    Open inner = open.element();
    boolean chained = inner.part == Part.LET_BODY && isWord(index, "let");
    return !inner.begins ? inner.further : chained ? inner.base : inner.base + 1;
  }

  /** Returns what a symbol ends, or divides; null for most symbols. */
  private Part end(int index) {
    Symbol symbol = symbols.get(index);
    if (symbol.is(")") || symbol.is("]") || symbol.is("}")) {
      return Part.BRACKET;
    } else if (!Spacing.isWord(symbols, index)) {
      return null;
    }
    return switch (symbol.text()) {
      case "then", "else", "elseif", "endif" -> Part.IF;
      case "in" -> Part.LET;
      default -> null;
    };
  }

  private boolean isWord(int index, String word) {
    return symbols.get(index).is(word) && Spacing.isWord(symbols, index);
  }

  /** Reads a symbol; returns false if it ends nothing that is open. */
  boolean accept(int index) {
    Symbol symbol = symbols.get(index);
    if (symbol.isFirstOfLine()) {
      line = level(index);
    }
    if (symbol.kind() == Kind.COMMENT) {
      return true;
    }
    int start = symbol.start();
    if (headings.outer().contains(start) || headings.members().contains(start)) {
      boolean complete = open.size() <= 1 || open.stream().allMatch(Indentation::endsWithClause);
      open.clear();
      push(Part.CLAUSE).begins = false;
      return complete;
    }
    Part ended = end(index);
    return ended == null ? read(index) : close(index, ended);
  }

  private static boolean endsWithClause(Open each) {
    return each.part == Part.CLAUSE || each.part == Part.LET_BODY;
  }

  private Open push(Part part) {
    open.push(new Open(part, line));
    return open.element();
  }

  private boolean close(int index, Part ended) {
    while (!open.isEmpty() && open.element().part == Part.LET_BODY) {
      open.pop();
    }
    if (open.isEmpty() || open.element().part != ended) {
      return false;
    }
    if (ended == Part.IF && !isWord(index, "endif")) {
      begin();
      return true;
    }
    Open closed = open.pop();
    if (ended == Part.LET) {
      open.push(new Open(Part.LET_BODY, closed.base));
    }
    return true;
  }

  private void begin() {
    open.element().begins = true;
  }

  private boolean read(int index) {
    Symbol symbol = symbols.get(index);
    if (open.isEmpty()) {
      return false;
    }
    Open inner = open.element();
    if (inner.begins) {
      boolean deeper = inner.part != Part.BRACKET;
      inner.further = symbol.isFirstOfLine() ? line + (deeper ? 1 : 0) : inner.base + 1;
      inner.begins = false;
    }
    if (symbol.is("(") || symbol.is("[") || symbol.is("{")) {
      push(Part.BRACKET);
    } else if (isWord(index, "if")) {
      push(Part.IF);
    } else if (isWord(index, "let")) {
      push(Part.LET);
    } else if (symbol.is("|") || symbol.is(",") || symbol.is(";")) {
      endLets();
      begin();
    } else if (headings.colons().contains(symbol.start())
        || headings.bodies().contains(symbol.start())) {
      begin();
    }
    return true;
  }

  private void endLets() {
    while (open.element().part == Part.LET_BODY) {
      open.pop();
    }
  }
}
