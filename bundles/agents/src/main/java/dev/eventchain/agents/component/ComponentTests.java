package dev.eventchain.agents.component;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The tests of a component in a file {@code tests/NAME.yaml}.
 *
 * @param tests calls and their expected results
 * @param properties properties over ranges of inputs
 */
record ComponentTests(List<Case> tests, List<Property> properties) {
  /** Copies the lists. */
  ComponentTests {
    tests = List.copyOf(tests);
    properties = List.copyOf(properties);
  }

  /**
   * Calls of a new component instance, and the expected outputs or the error of the last one.
   *
   * @param requirement the id of the tested requirement
   * @param calls the inputs of each call, see {@link TestValues}
   * @param outputs the expectations by output name; not necessarily for all outputs; none if the
   *     last call raises
   * @param raises the error that the last call raises; empty if it returns
   */
  record Case(
      String name,
      String requirement,
      List<Map<String, JsonNode>> calls,
      Map<String, TestExpectation> outputs,
      Optional<ExpectedError> raises,
      SourceLocation place) {}

  /** Kinds of properties of an output. */
  enum Kind {
    /** The output is within bounds. */
    RANGE("within"),
    /** The output never decreases when an input increases. */
    RISES("rises_with"),
    /** The output never increases when an input increases. */
    FALLS("falls_with");

    private final String key;

    Kind(String key) {
      this.key = key;
    }

    /** Returns the key of the kind in a file. */
    String key() {
      return key;
    }
  }

  /**
   * A property of an output, evaluated for single calls of new component instances.
   *
   * @param bounds the bounds of the output, for a range property
   * @param input the increasing input, for the other kinds
   * @param over the ranges of the varied inputs, from first to last value
   * @param inputs the values of the other inputs
   */
  record Property(
      String name,
      String requirement,
      Kind kind,
      String output,
      Optional<TestExpectation> bounds,
      String input,
      Map<String, double[]> over,
      Map<String, JsonNode> inputs,
      SourceLocation place) {}
}
