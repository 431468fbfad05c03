package dev.eventchain.agents.component;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.util.Optional;

/**
 * The expected output of a test: an exact value, a number within a tolerance, or a number within
 * bounds.
 *
 * @param exact the value, if one is stated; a number, a Boolean, a string or an array
 * @param tolerance the largest accepted distance from it
 * @param least the least number; used without a value only, as the following ones
 * @param above true if the least number itself is too small
 * @param most the greatest number
 * @param below true if the greatest number itself is too large
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

  /** Default tolerance of numbers, for rounding that depends on the order of operations. */
  private static final double ROUNDING = 1e-6;

  /** Returns the expectation of a value alone. */
  static TestExpectation exactly(JsonNode value) {
    return exactly(value, rounding(value));
  }

  private static TestExpectation exactly(JsonNode value, double tolerance) {
    JsonNode whole = TestValues.expanded(value);
    return new TestExpectation(Optional.of(whole), tolerance, 0, false, 0, false);
  }

  /** Reads an object with {@code value} and {@code tolerance}, or with bounds. */
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

  /** Returns whether an output is as expected. */
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

  /** Returns whether it is about a single number that need not have one exact value. */
  boolean isNumeric() {
    return exact.isEmpty()
        || (TestValues.literal(exact.get()).isPresent() && tolerance > rounding(exact.get()));
  }

  private static double rounding(JsonNode value) {
    return ROUNDING * Math.max(1, Math.abs(value.asDouble()));
  }

  /** Returns the least accepted number; NaN if no number is expected. */
  double smallest() {
    return exact.map(value -> middle(value) - tolerance).orElse(least);
  }

  /** Returns the greatest accepted number; NaN if no number is expected. */
  double greatest() {
    return exact.map(value -> middle(value) + tolerance).orElse(most);
  }

  private static double middle(JsonNode value) {
    return TestValues.literal(value).orElse(Double.NaN);
  }

  /** Returns a short description. */
  String words() {
    if (exact.isPresent()) {
      boolean stated = tolerance > rounding(exact.get());
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
