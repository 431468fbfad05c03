package dev.eventchain.ocl.text;

import dev.eventchain.ocl.text.Symbol.Kind;
import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Set;

/**
 * The usual spaces between the symbols of a line: around operators and the colon before a type,
 * after commas, and none inside parentheses or around dots and arrows. Where more than one way is
 * usual, a space stays if there is one. Spaces never join or divide what the parser reads as one
 * symbol.
 */
public final class Spacing {

  private static final Set<String> WORDS =
      Set.of(
          "and", "or", "xor", "implies", "not", "if", "then", "else", "elseif", "endif", "let",
          "in");

  private static final Set<String> INFIX = Set.of("=", "<>", "<=", ">=", "<", ">", "+", "/", "|");
  private static final Set<String> NAVIGATION = Set.of(".", "->", "::", "?.", "?->");
  private static final Set<String> OPENING = Set.of("(", "[", "{");
  private static final Set<String> CLOSING = Set.of(")", "]", "}");
  private static final Set<String> SEPARATORS = Set.of(",", ";");

  private final List<Symbol> symbols;
  private final Set<Integer> headings;
  private final Set<String> loose;

  /** Signs without a left operand, and stars that are numbers. */
  private final BitSet prefixes = new BitSet();

  /** Braces of literals, which hold their elements without spaces. */
  private final BitSet tight = new BitSet();

  /**
   * Finds the operands of operators.
   *
   * @param headings the offsets of colons that end the heading of a clause
   * @param loose names that are words of a language around OCL: a space between one of them and a
   *     parenthesis stays
   */
  public Spacing(List<Symbol> symbols, Set<Integer> headings, Set<String> loose) {
    this.symbols = symbols;
    this.headings = headings;
    this.loose = loose;
    Deque<Boolean> braces = new ArrayDeque<>();
    for (int i = 0; i < symbols.size(); i++) {
      Symbol symbol = symbols.get(i);
      if (symbol.is("-") || symbol.is("*")) {
        prefixes.set(i, isOperandExpected(i));
      } else if (symbol.is("{")) {
        int before = before(i);
        braces.push(before >= 0 && isName(before));
        tight.set(i, braces.peek());
      } else if (symbol.is("}") && !braces.isEmpty()) {
        tight.set(i, braces.pop());
      }
    }
  }

  /** Returns whether a symbol is a word of the language, and no name of a feature. */
  public static boolean isWord(List<Symbol> symbols, int index) {
    Symbol symbol = symbols.get(index);
    return symbol.kind() == Kind.NAME
        && WORDS.contains(symbol.text())
        && !(index > 0 && isNavigation(symbols.get(index - 1)));
  }

  private static boolean isNavigation(Symbol symbol) {
    return symbol.kind() == Kind.SIGN && NAVIGATION.contains(symbol.text());
  }

  private boolean isName(int index) {
    return symbols.get(index).kind() == Kind.NAME && !isWord(symbols, index);
  }

  /** Returns the index of the symbol before one that is no comment; -1 if there is none. */
  private int before(int index) {
    int before = index - 1;
    while (before >= 0 && symbols.get(before).kind() == Kind.COMMENT) {
      before--;
    }
    return before;
  }

  private boolean isOperandExpected(int index) {
    int before = before(index);
    if (before < 0) {
      return true;
    }
    Symbol symbol = symbols.get(before);
    return switch (symbol.kind()) {
      case NAME -> isWord(symbols, before) && !symbol.is("endif");
      case SIGN -> !CLOSING.contains(symbol.text()) && !(symbol.is("*") && prefixes.get(before));
      default -> false;
    };
  }

  /** Returns what comes before a symbol that is not the first of its line. */
  public String before(Symbol next, int index) {
    String gap = next.gap();
    Symbol previous = symbols.get(index - 1);
    if (next.kind() == Kind.COMMENT && next.text().startsWith("--")) {
      return gap.isEmpty() ? " " : gap; // people align these
    } else if (!gap.chars().allMatch(c -> c == ' ' || c == '\t')) {
      return gap;
    } else if (previous.kind() == Kind.COMMENT || next.kind() == Kind.COMMENT) {
      return gap.isEmpty() ? "" : " ";
    }
    return switch (wanted(previous, next, index)) {
      case NONE -> "";
      case ONE -> " ";
      case SAME -> gap.isEmpty() ? "" : " ";
    };
  }

  private enum Wanted {
    NONE,
    ONE,
    SAME
  }

  private Wanted wanted(Symbol previous, Symbol next, int index) {
    if (next.kind() == Kind.SIGN) {
      Wanted before = beforeSign(previous, next, index);
      if (before != Wanted.SAME) {
        return before;
      }
    }
    return previous.kind() == Kind.SIGN
        ? afterSign(previous, next, index)
        : isWord(symbols, index - 1) || isWord(symbols, index) ? Wanted.ONE : Wanted.SAME;
  }

  private Wanted beforeSign(Symbol previous, Symbol next, int index) {
    String sign = next.text();
    if (isInfix(index)) {
      // Operators that touch each other may be one of another language, and thus a mistake.
      boolean isOne = next.gap().isEmpty() && (isInfix(index - 1) || previous.is(":"));
      return isOne ? Wanted.NONE : Wanted.ONE;
    } else if (sign.equals(":")) {
      return headings.contains(next.start()) ? Wanted.NONE : Wanted.ONE;
    } else if (SEPARATORS.contains(sign) || sign.equals(")") || sign.equals("]")) {
      return Wanted.NONE;
    } else if (sign.equals("}")) {
      return tight.get(index) ? Wanted.NONE : Wanted.SAME;
    } else if (NAVIGATION.contains(sign)) {
      return previous.kind() == Kind.NUMBER || isTight(previous) ? Wanted.SAME : Wanted.NONE;
    } else if (OPENING.contains(sign) && previous.kind() == Kind.NAME) {
      return isName(index - 1) ? called(previous, sign) : Wanted.ONE;
    }
    return Wanted.SAME;
  }

  private Wanted called(Symbol name, String sign) {
    return sign.equals("[") || loose.contains(name.text()) ? Wanted.SAME : Wanted.NONE;
  }

  /** Returns whether a sign might become another one with what is joined to it. */
  private static boolean isTight(Symbol symbol) {
    return symbol.kind() == Kind.SIGN && !CLOSING.contains(symbol.text());
  }

  private Wanted afterSign(Symbol previous, Symbol next, int index) {
    String sign = previous.text();
    if (isInfix(index - 1) || sign.equals(":") || SEPARATORS.contains(sign)) {
      return Wanted.ONE;
    } else if (sign.equals("{")) {
      return tight.get(index - 1) ? Wanted.NONE : Wanted.SAME;
    } else if (OPENING.contains(sign)) {
      return Wanted.NONE;
    } else if (sign.equals("-") || NAVIGATION.contains(sign)) {
      return isTight(next) ? Wanted.SAME : Wanted.NONE;
    }
    boolean isPart = CLOSING.contains(sign) && loose.contains(next.text());
    return isPart || isWord(symbols, index) ? Wanted.ONE : Wanted.SAME;
  }

  private boolean isInfix(int index) {
    Symbol symbol = symbols.get(index);
    return symbol.kind() == Kind.SIGN
        && (INFIX.contains(symbol.text())
            || ((symbol.is("-") || symbol.is("*")) && !prefixes.get(index)));
  }
}
