package dev.eventchain.openscenario.expression;

import dev.eventchain.diagnostics.NearestName;
import java.util.ArrayList;
import java.util.List;

/**
 * The evaluation of one expression. Operators by rank, the last ones bind most closely: {@code or};
 * {@code and}; {@code + -}; {@code * / %}; {@code not} and the sign; functions and parentheses.
 */
public final class Expression {

  private static final int DEEPEST = 200;

  /** The parameters of an expression. */
  @FunctionalInterface
  public interface Parameters {

    /** Returns the value of a parameter, or says why there is none. */
    Operand value(String name) throws ExpressionException;
  }

  private final Tokens tokens;
  private final Parameters parameters;
  private int depth;

  private Expression(Tokens tokens, Parameters parameters) {
    this.tokens = tokens;
    this.parameters = parameters;
  }

  /**
   * Evaluates an expression. Numbers are computed as doubles: a division of whole numbers has a
   * fraction.
   *
   * @param text the text between the braces
   * @throws ExpressionException if it is wrong, or has no value: a division by zero, a number that
   *     is too large, a root of a negative number
   */
  public static Operand evaluate(String text, Parameters parameters) throws ExpressionException {
    Expression expression = new Expression(new Tokens(text), parameters);
    Operand value = expression.disjunction();
    if (!expression.tokens.peek().equals(Tokens.END)) {
      throw new ExpressionException("An operator is missing " + expression.tokens.before() + ".");
    }
    return value;
  }

  private Operand disjunction() throws ExpressionException {
    if (++depth > DEEPEST) {
      throw new ExpressionException("It is nested too deeply.");
    }
    Operand value = conjunction();
    while (tokens.takes("or")) {
      boolean other = conjunction().truth("or");
      value = new Operand.Truth(value.truth("or") || other);
    }
    depth--;
    return value;
  }

  private Operand conjunction() throws ExpressionException {
    Operand value = sum();
    while (tokens.takes("and")) {
      boolean other = sum().truth("and");
      value = new Operand.Truth(value.truth("and") && other);
    }
    return value;
  }

  private Operand sum() throws ExpressionException {
    Operand value = product();
    while (tokens.peek().equals("+") || tokens.peek().equals("-")) {
      String operator = tokens.take();
      double first = value.number(operator);
      double second = product().number(operator);
      value = finite(operator, operator.equals("+") ? first + second : first - second);
    }
    return value;
  }

  private Operand product() throws ExpressionException {
    Operand value = signed();
    while (List.of("*", "/", "%").contains(tokens.peek())) {
      String operator = tokens.take();
      double first = value.number(operator);
      double second = signed().number(operator);
      if (second == 0 && !operator.equals("*")) {
        throw new ExpressionException("It divides by zero.");
      }
      value =
          finite(
              operator,
              switch (operator) {
                case "*" -> first * second;
                case "/" -> first / second;
                default -> first % second;
              });
    }
    return value;
  }

  private Operand signed() throws ExpressionException {
    if (++depth > DEEPEST) {
      throw new ExpressionException("It is nested too deeply.");
    }
    Operand value;
    if (tokens.takes("-")) {
      value = finite("-", -signed().number("-"));
    } else if (tokens.takes("+")) {
      value = finite("+", signed().number("+"));
    } else if (tokens.takes("not")) {
      value = new Operand.Truth(!signed().truth("not"));
    } else {
      value = term();
    }
    depth--;
    return value;
  }

  private Operand term() throws ExpressionException {
    String place = tokens.before();
    String token = tokens.take();
    if (token.equals("(")) {
      Operand value = disjunction();
      tokens.expect(")");
      return value;
    } else if (token.startsWith("$")) {
      return parameters.value(token.substring(1));
    } else if (!token.isEmpty() && (Character.isDigit(token.charAt(0)) || token.startsWith("."))) {
      return finite(token, Double.parseDouble(token));
    } else if (!token.isEmpty() && Character.isLetter(token.charAt(0))) {
      return word(token);
    }
    throw new ExpressionException("A value is missing " + place + ".");
  }

  private Operand word(String word) throws ExpressionException {
    return switch (word) {
      case "true" -> new Operand.Truth(true);
      case "false" -> new Operand.Truth(false);
      case "pi" -> new Operand.Numeric(Math.PI);
      default -> call(word);
    };
  }

  private Operand call(String function) throws ExpressionException {
    boolean ofOne = Functions.OF_ONE.containsKey(function);
    if (!ofOne && !Functions.OF_TWO.containsKey(function)) {
      List<String> known = new ArrayList<>(Functions.OF_ONE.keySet());
      known.addAll(Functions.OF_TWO.keySet());
      known.addAll(List.of("and", "or", "not", "pi", "true", "false"));
      throw new ExpressionException(
          ("`"
                  + function
                  + "` is unknown; a parameter begins with $. "
                  + NearestName.question(function, known))
              .strip());
    }
    tokens.expect("(");
    double first = disjunction().number(function);
    if (ofOne) {
      tokens.expect(")");
      return finite(function, Functions.OF_ONE.get(function).applyAsDouble(first));
    }
    tokens.expect(",");
    double second = disjunction().number(function);
    tokens.expect(")");
    return finite(function, Functions.OF_TWO.get(function).applyAsDouble(first, second));
  }

  private static Operand finite(String user, double value) throws ExpressionException {
    if (Double.isNaN(value)) {
      throw new ExpressionException("`" + user + "` has no value for these numbers.");
    } else if (Double.isInfinite(value)) {
      throw new ExpressionException("The value of `" + user + "` is too large.");
    }
    return new Operand.Numeric(value + 0.0); // -0 is 0
  }
}
