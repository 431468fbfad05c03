package dev.eventchain.ocl.parse;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import lpg.runtime.IToken;
import lpg.runtime.PrsStream;
import lpg.runtime.Token;
import org.eclipse.ocl.cst.VariableCS;
import org.eclipse.ocl.parser.OCLParsersym;

/**
 * Reads syntax of Eclipse's newer dialect by its older grammar: {@code elseif c then x} as {@code
 * else if c then x} with one more {@code endif} at the end, and variables that begin with a value,
 * as in {@code let x = y} and {@code iterate(e; x = y | z)}, as if a type were written, which
 * {@link #isTyped} tells from one that is. Added tokens are where written ones are.
 */
final class NewerSyntax {

  private static final Set<Integer> BEFORE_NAMES =
      Set.of(OCLParsersym.TK_DOT, OCLParsersym.TK_ARROW, OCLParsersym.TK_COLONCOLON);

  private static final Set<Integer> OPENING =
      Set.of(
          OCLParsersym.TK_let,
          OCLParsersym.TK_LPAREN,
          OCLParsersym.TK_LBRACE,
          OCLParsersym.TK_LBRACKET);

  private static final Set<Integer> CLOSING =
      Set.of(
          OCLParsersym.TK_in,
          OCLParsersym.TK_RPAREN,
          OCLParsersym.TK_RBRACE,
          OCLParsersym.TK_RBRACKET);

  private final PrsStream stream;
  private final List<IToken> written;
  private final List<IToken> tokens = new ArrayList<>();

  /** For each {@code if} that is not closed yet, the number of ends to add. */
  private final Deque<Integer> ends = new ArrayDeque<>();

  /** Variables and brackets that are not closed yet. */
  private final Deque<Integer> open = new ArrayDeque<>();

  @SuppressWarnings("unchecked") // The list has tokens only.
  private NewerSyntax(PrsStream stream) {
    this.stream = stream;
    this.written = new ArrayList<>(stream.getTokens());
  }

  /** Adds the tokens of the older grammar to those of a text. */
  static void spellOut(PrsStream stream) {
    NewerSyntax syntax = new NewerSyntax(stream);
    for (int i = 0; i < syntax.written.size(); i++) {
      syntax.add(i);
    }
    if (syntax.tokens.size() > syntax.written.size()) {
      syntax.replace();
    }
  }

  /** Returns whether the type of a variable is written. */
  static boolean isTyped(VariableCS variable) {
    return variable.getTypeCS() == null
        || variable.getTypeCS().getStartOffset() != variable.getStartOffset();
  }

  private void add(int index) {
    IToken token = written.get(index);
    int kind = token.getKind();
    follow(kind);
    if (kind == OCLParsersym.TK_if) {
      ends.push(0);
    } else if (isElseIf(index) && !ends.isEmpty()) {
      ends.push(ends.pop() + 1);
      tokens.add(copy(token, OCLParsersym.TK_else));
      token.setKind(OCLParsersym.TK_if);
    } else if (kind == OCLParsersym.TK_EQUAL && isUntypedVariable(index - 1)) {
      IToken name = written.get(index - 1);
      tokens.add(copy(name, OCLParsersym.TK_COLON));
      tokens.add(copy(name, OCLParsersym.TK_IDENTIFIER));
    }
    tokens.add(token);
    if (kind == OCLParsersym.TK_endif && !ends.isEmpty()) {
      for (int i = ends.pop(); i > 0; i--) {
        tokens.add(copy(token, kind));
      }
    }
  }

  private void follow(int kind) {
    if (OPENING.contains(kind)) {
      open.push(kind);
    } else if (CLOSING.contains(kind)) {
      open.poll();
    }
  }

  private boolean isElseIf(int index) {
    return written.get(index).getKind() == OCLParsersym.TK_IDENTIFIER
        && stream.getTokenText(index).equals("elseif")
        && !BEFORE_NAMES.contains(tokens.get(tokens.size() - 1).getKind());
  }

  private boolean isUntypedVariable(int index) {
    if (index < 1 || written.get(index).getKind() != OCLParsersym.TK_IDENTIFIER) {
      return false;
    }
    int before = written.get(index - 1).getKind();
    boolean isNext = before == OCLParsersym.TK_COMMA && isIn(OCLParsersym.TK_let);
    boolean isResult = before == OCLParsersym.TK_SEMICOLON && isIn(OCLParsersym.TK_LPAREN);
    return isNext || isResult || before == OCLParsersym.TK_let;
  }

  private boolean isIn(int kind) {
    return !open.isEmpty() && open.peek() == kind;
  }

  private static IToken copy(IToken token, int kind) {
    return new Token(token.getIPrsStream(), token.getStartOffset(), token.getEndOffset(), kind);
  }

  @SuppressWarnings("unchecked") // The list has tokens only.
  private void replace() {
    for (int i = 0; i < tokens.size(); i++) {
      tokens.get(i).setTokenIndex(i);
    }
    stream.getTokens().clear();
    stream.getTokens().addAll(tokens);
    stream.setStreamLength();
  }
}
