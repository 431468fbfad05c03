package dev.eventchain.agents.component;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The tests of a component, as a file {@code tests/NAME.yaml} states them.
 *
 * @param tests calls and what must come of them
 * @param properties what must be true over ranges of inputs
 */
record ComponentTests(List<Case> tests, List<Property> properties) {
  /** Copies the lists. */
  ComponentTests {
    tests = List.copyOf(tests);
    properties = List.copyOf(properties);
  }

  /**
   * Calls on a new component, and what its outputs must be after the last one.
   *
   * @param requirement the id of the requirement that asks for it
   * @param calls the inputs of each call, as {@link TestValues} reads them
   * @param outputs what is expected, by the names of outputs; not of all of them
   */
  record Case(
      String name,
      String requirement,
      List<Map<String, JsonNode>> calls,
      Map<String, TestExpectation> outputs,
      SourceLocation place) {}

  /** What a property says of its output. */
  enum Kind {
    /** It is within bounds. */
    RANGE("within"),
    /** It never gets smaller when an input gets larger. */
    RISES("rises_with"),
    /** It never gets larger when an input gets larger. */
    FALLS("falls_with");

    private final String key;

    Kind(String key) {
      this.key = key;
    }

    /** What says it in a file. */
    String key() {
      return key;
    }
  }

  /**
   * What must be true of an output, each time of a new component that is called once.
   *
   * @param bounds of the output where the property is a range
   * @param input the one that gets larger where it is not
   * @param over the ranges of the inputs that are varied, from first to last
   * @param inputs the others
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
