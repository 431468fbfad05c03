package dev.eventchain.openscenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.openscenario.expression.Expression;
import dev.eventchain.openscenario.expression.ExpressionException;
import dev.eventchain.openscenario.expression.Operand;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Expressions, against the values that Python computes; {@code random_expressions.py}. */
class ExpressionTest {

  private static final Map<String, Operand> PARAMETERS =
      Map.of(
          "speed", new Operand.Numeric(13.5),
          "count", new Operand.Numeric(3),
          "zero", new Operand.Numeric(0),
          "offset", new Operand.Numeric(-2.25),
          "tiny", new Operand.Numeric(1e-300),
          "huge", new Operand.Numeric(1e300),
          "day", new Operand.Truth(true),
          "wet", new Operand.Truth(false));

  /** Errors of the last place add up over the functions of an expression. */
  private static final double TOLERANCE = 1e-9;

  private static String value(String expression) {
    try {
      return Expression.evaluate(expression, PARAMETERS::get).text();
    } catch (ExpressionException e) {
      return "none";
    }
  }

  @Test
  void valuesAreThoseOfPython() throws IOException {
    int numbers = 0;
    for (String line : Files.readAllLines(Path.of("src/test/resources/expressions.tsv"))) {
      String[] columns = line.split("\t", 2);
      String actual = value(columns[0]);
      if (columns[1].matches("none|true|false")) {
        assertEquals(columns[1], actual, columns[0]);
      } else {
        assertNotEquals("none", actual, columns[0]);
        double expected = Double.parseDouble(columns[1]);
        double error = Math.abs(Double.parseDouble(actual) - expected);
        assertTrue(error <= TOLERANCE * Math.max(1, Math.abs(expected)), line + " is " + actual);
        numbers++;
      }
    }
    assertTrue(numbers > 400, numbers + " numbers");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "7/2 | 3.5",
        "-7 % 3 | -1",
        "2 - 3 - 4 | -5",
        "2 * -3 | -6",
        "--2 | 2",
        "-pow(2, 2) | -4",
        "round(-2.5) | -3",
        "round(0.49999999999999994) | 0",
        "65*pi/180 | 1.1344640137963142",
        "not true or true | true",
        "not (true or true) | false",
        "sign(-100)*min(1.0,100.0-75) | -1",
        "1e15 | 1.0E15",
        "-0 | 0",
      })
  void expressionsHaveTheirValues(String expression, String expected) {
    assertEquals(expected, value(expression));
  }

  /** Any text gives a value or a sentence, and never another exception. */
  @Test
  void anyTextHasAValueOrAReason() {
    String[] words = {
      "$speed", "$day", "(", ")", "+", "-", "*", "/", "%", ",", "not", "and", "or", "min", "sqrt",
      "1", "0", "1e999", "pi", "$", "{", "\u00e4", "", " ", "true", "1.2.3", "$$a"
    };
    Random random = new Random(36);
    for (int i = 0; i < 20_000; i++) {
      StringBuilder text = new StringBuilder();
      for (int j = random.nextInt(12); j >= 0; j--) {
        text.append(words[random.nextInt(words.length)]).append(random.nextBoolean() ? " " : "");
      }
      try {
        Expression.evaluate(
            text.toString(), name -> PARAMETERS.getOrDefault(name, new Operand.Text("")));
      } catch (ExpressionException e) {
        assertTrue(e.getMessage().matches("[A-Z`].*[.?]"), text + ": " + e.getMessage());
      }
    }
  }
}
