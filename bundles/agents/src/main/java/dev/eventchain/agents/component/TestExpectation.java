package dev.eventchain.agents.component;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.util.Optional;

/**
 * What an output must be after a test: exactly a value, a number within a tolerance of another one,
 * or a number within bounds.
 *
 * @param exact the value, if one is stated; a number, a Boolean, a string or an array
 * @param tolerance how far numbers may be from it
 * @param least the least number; only where no value is stated, as those below
 * @param above whether the least number itself is too small
 * @param most the greatest number
 * @param below whether the greatest number itself is too large
 */
record TestExpectation(
    Optional<JsonNode> exact,
    double tolerance,
    double least,
    boolean above,
    double most,
    boolean below) {
  private static final NumberRange ANY = NumberRange.of(-Double.MAX_VALUE, Double.MAX_VALUE);
  private static final NumberRange TOLERANCE = NumberRange.of(0, Double.MAX_VALUE);

  /** For numbers of which nothing else is said: what arithmetic in another order may change. */
  private static final double ROUNDING = 1e-6;

  /** A value that stands alone. */
  static TestExpectation exactly(JsonNode value) {
    return exactly(value, ROUNDING * Math.max(1, Math.abs(value.asDouble())));
  }

  private static TestExpectation exactly(JsonNode value, double tolerance) {
    return new TestExpectation(Optional.of(value), tolerance, 0, false, 0, false);
  }

  /** Reads an object: {@code value} and {@code tolerance}, or bounds. */
  static Optional<TestExpectation> read(ObjectReader object) {
    Optional<TestExpectation> read =
        object.has("value") ? valueWithTolerance(object) : bounds(object);
    object.refuseOthers();
    return read;
  }

  private static Optional<TestExpectation> valueWithTolerance(ObjectReader object) {
    JsonNode value = object.value("value").orElseThrow();
    double tolerance = object.number("tolerance", TOLERANCE).orElse(exactly(value).tolerance());
    return Optional.of(exactly(value, tolerance));
  }

  private static Optional<TestExpectation> bounds(ObjectReader object) {
    boolean above = object.has("above");
    boolean below = object.has("below");
    double least =
        object.number(above ? "above" : "at_least", ANY).orElse(Double.NEGATIVE_INFINITY);
    double most = object.number(below ? "below" : "at_most", ANY).orElse(Double.POSITIVE_INFINITY);
    if ((least == Double.NEGATIVE_INFINITY && most == Double.POSITIVE_INFINITY) || least > most) {
      object.find(
          ComponentTestsReader.FORMAT,
          "Nothing is expected here, or nothing that is possible.",
          object.location());
      return Optional.empty();
    }
    return Optional.of(new TestExpectation(Optional.empty(), 0, least, above, most, below));
  }

  /** Whether an output is as expected. */
  boolean accepts(JsonNode actual) {
    return exact.map(value -> equal(value, actual)).orElseGet(() -> isWithin(actual));
  }

  private boolean isWithin(JsonNode actual) {
    if (!actual.isNumber()) {
      return false;
    }
    double number = actual.asDouble();
    return (above ? number > least : number >= least) && (below ? number < most : number <= most);
  }

  private boolean equal(JsonNode expected, JsonNode actual) {
    if (expected.isArray()) {
      boolean equal = actual.isArray() && actual.size() == expected.size();
      for (int i = 0; equal && i < expected.size(); i++) {
        equal = equal(expected.get(i), actual.get(i));
      }
      return equal;
    }
    Optional<Double> number = TestValues.literal(expected);
    if (number.isPresent() && actual.isNumber()) {
      double difference = Math.abs(number.get() - actual.asDouble());
      return difference <= tolerance || number.get().equals(actual.asDouble());
    }
    return expected.equals(actual);
  }

  /** The least number that is accepted; NaN where no number is expected. */
  double smallest() {
    return exact.map(value -> middle(value) - tolerance).orElse(least);
  }

  /** The greatest number that is accepted; NaN where no number is expected. */
  double greatest() {
    return exact.map(value -> middle(value) + tolerance).orElse(most);
  }

  private static double middle(JsonNode value) {
    return TestValues.literal(value).orElse(Double.NaN);
  }

  /** In a few words. */
  String words() {
    if (exact.isPresent()) {
      boolean stated = tolerance > ROUNDING * Math.max(1, Math.abs(exact.get().asDouble()));
      return exact.get() + (stated ? " within " + tolerance : "");
    }
    String from = (above ? "above " : "at least ") + least;
    String to = (below ? "below " : "at most ") + most;
    if (least == Double.NEGATIVE_INFINITY) {
      return to;
    }
    return most == Double.POSITIVE_INFINITY ? from : from + " and " + to;
  }
}
