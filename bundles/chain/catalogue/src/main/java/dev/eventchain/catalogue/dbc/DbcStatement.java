package dev.eventchain.catalogue.dbc;

import dev.eventchain.catalogue.dbc.DbcTokens.Kind;
import dev.eventchain.catalogue.dbc.DbcTokens.Token;
import dev.eventchain.catalogue.dbc.DbcTokens.UnreadException;
import java.math.BigDecimal;

/** The parts of statements, token by token. */
final class DbcStatement {

  /** Longest number, in characters: those that are written are far shorter. */
  private static final int LONGEST_NUMBER = 60;

  /** Largest exponent of ten: more than any double has. */
  private static final int LARGEST_EXPONENT = 400;

  private final DbcTokens tokens;

  DbcStatement(DbcTokens tokens) {
    this.tokens = tokens;
  }

  /** Returns where the next token begins. */
  int offset() {
    return tokens.peek().offset();
  }

  Token word() throws UnreadException {
    return of(Kind.WORD, "a name");
  }

  String text() throws UnreadException {
    return of(Kind.TEXT, "a text in quotation marks").text();
  }

  /** Returns a number that is neither huge nor tiny beyond all floating-point numbers. */
  BigDecimal number() throws UnreadException {
    Token token = of(Kind.NUMBER, "a number");
    if (token.text().length() <= LONGEST_NUMBER) {
      String digits = token.text().replaceFirst("^[-+]?", "").replaceFirst("[eE].*$", "");
      String exponent = token.text().replaceFirst("^[^eE]*[eE]?", "");
      if (exponent.length() <= 4 && exponent(exponent) <= LARGEST_EXPONENT) {
        String sign = token.text().startsWith("-") ? "-" : "";
        String power = exponent.isEmpty() ? "" : "e" + exponent;
        return new BigDecimal(sign + digits.replaceFirst("\\.$", "") + power);
      }
    }
    throw new UnreadException("This number is not read.", token.offset());
  }

  private static int exponent(String written) {
    return written.isEmpty() ? 0 : Math.abs(Integer.parseInt(written));
  }

  /** Returns a whole number from 0 to a largest one. */
  long whole(long largest) throws UnreadException {
    Token token = tokens.peek();
    BigDecimal number = number();
    boolean whole = number.stripTrailingZeros().scale() <= 0 && number.signum() >= 0;
    if (!whole || number.compareTo(BigDecimal.valueOf(largest)) > 0) {
      throw new UnreadException(
          "A whole number from 0 to " + largest + " is expected here.", token.offset());
    }
    return number.longValueExact();
  }

  void sign(String expected) throws UnreadException {
    if (!tokens.peek().is(expected)) {
      throw expected("'" + expected + "'");
    }
    tokens.take();
  }

  /** Takes a sign if it is next. */
  boolean takes(String sign) throws UnreadException {
    boolean is = tokens.peek().is(sign);
    if (is) {
      tokens.take();
    }
    return is;
  }

  boolean isNext(Kind kind) {
    return tokens.peek().kind() == kind;
  }

  /** Passes over the rest of a statement with its semicolon. */
  void pass() throws UnreadException {
    while (!takes(";")) {
      if (isNext(Kind.END)) {
        throw expected("';'");
      }
      tokens.take();
    }
  }

  private Token of(Kind kind, String name) throws UnreadException {
    if (!isNext(kind)) {
      throw expected(name);
    }
    return tokens.take();
  }

  private UnreadException expected(String what) {
    Token token = tokens.peek();
    String found =
        switch (token.kind()) {
          case END -> "the end of the file";
          case TEXT -> "a text";
          default -> "'" + token.text() + "'";
        };
    return new UnreadException("Here " + what + " is expected, not " + found + ".", token.offset());
  }
}
