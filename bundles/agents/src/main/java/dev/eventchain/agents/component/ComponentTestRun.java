package dev.eventchain.agents.component;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import dev.eventchain.agents.chain.ChainView.Component;
import dev.eventchain.agents.chain.ChainView.Value;
import dev.eventchain.agents.component.ComponentTests.Case;
import dev.eventchain.agents.component.ComponentTests.Kind;
import dev.eventchain.agents.component.ComponentTests.Property;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.sandbox.CallResults;
import dev.eventchain.sandbox.ComponentCall;
import dev.eventchain.sandbox.ComponentProbe;
import dev.eventchain.sandbox.ComponentRules;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/** Runs the tests of a component on its code. */
final class ComponentTestRun {
  /** Number of samples of a range, including its ends. */
  private static final int SAMPLES = 41;

  private static final int LONGEST_VALUE = 200;

  private final Component component;
  private final ComponentTests tests;
  private final List<List<ComponentCall>> sequences = new ArrayList<>();
  private boolean ended;

  ComponentTestRun(Component component, ComponentTests tests) {
    this.component = component;
    this.tests = tests;
    tests.tests().forEach(test -> sequences.add(calls(test.name(), test.calls())));
    for (Property property : tests.properties()) {
      for (Map<String, JsonNode> sample : samples(property)) {
        sequences.add(calls(property.name(), List.of(sample)));
      }
    }
    if (returning() >= 0) {
      sequences.add(sequences.get(returning())); // again, after calls of other component objects
    }
  }

  /** Returns the index of the first test whose calls all return; -1 if there is none. */
  private int returning() {
    List<Case> all = tests.tests();
    return IntStream.range(0, all.size())
        .filter(number -> all.get(number).raises().isEmpty())
        .findFirst()
        .orElse(-1);
  }

  /**
   * Runs the tests.
   *
   * @param file the component
   * @return failed expectations, located in the tests; and problems that prevent calls, located in
   *     the component
   */
  List<Diagnostic> run(ComponentProbe probe, Path file) {
    if (sequences.isEmpty()) {
      return List.of();
    }
    List<CallResults> results = probe.call(file, component.signature(), sequences);
    ended =
        results.stream()
            .flatMap(each -> each.problem().stream())
            .anyMatch(problem -> problem.is(ComponentRules.ENDED));
    if (results.size() != sequences.size()) {
      return List.of(results.get(0).problem().orElseThrow()); // the probe reports the reason
    }
    List<Diagnostic> found = new ArrayList<>();
    int next = 0;
    for (Case test : tests.tests()) {
      found.addAll(judge(test, results.get(next++)));
    }
    for (Property property : tests.properties()) {
      List<Map<String, JsonNode>> samples = samples(property);
      found.addAll(judge(property, samples, results.subList(next, next + samples.size())));
      next += samples.size();
    }
    int first = returning();
    if (found.isEmpty() && first >= 0) {
      found.addAll(sameAgain(tests.tests().get(first), results.get(first), results.get(next)));
    }
    return found;
  }

  /** Returns whether a call ended the process of the component in the last run. */
  boolean ended() {
    return ended;
  }

  /** Returns the calls of the first test or property that return; empty if there is none. */
  List<ComponentCall> first() {
    int first = returning() >= 0 ? returning() : tests.tests().size();
    return first < sequences.size() ? sequences.get(first) : List.of();
  }

  private static Optional<Diagnostic> unraised(
      Case test, ExpectedError expected, CallResults result) {
    int returned = result.outputs().size();
    boolean raised =
        returned == test.calls().size() - 1
            && result.problem().filter(each -> expected.accepts(each, test.name())).isPresent();
    String instead =
        result
            .problem()
            .map(each -> problem(each))
            .orElseGet(() -> "It returned " + shortened(result.outputs().get(returned - 1) + "."));
    String message = "Call %d should raise %s. %s";
    return raised
        ? Optional.empty()
        : Optional.of(
            failed(
                test.name(),
                test.requirement(),
                test.place(),
                message.formatted(test.calls().size(), expected.words(), instead)));
  }

  private List<Diagnostic> judge(Case test, CallResults result) {
    if (test.raises().isPresent()) {
      return unraised(test, test.raises().get(), result).stream().toList();
    }
    String inputs = shown(test.calls().get(test.calls().size() - 1));
    if (result.problem().isPresent()) {
      return List.of(
          failed(test.name(), test.requirement(), test.place(), problem(result.problem().get())));
    }
    JsonNode last = result.outputs().get(test.calls().size() - 1);
    List<Diagnostic> found = new ArrayList<>();
    test.outputs()
        .forEach(
            (output, expected) -> {
              if (!expected.accepts(last.path(output))) {
                String message =
                    "'%s' is %s, not %s, %swith %s."
                        .formatted(
                            output,
                            shortened(last.path(output).toString()),
                            shortened(expected.words()),
                            test.calls().size() == 1 ? "" : "in call " + test.calls().size() + " ",
                            inputs);
                found.add(failed(test.name(), test.requirement(), test.place(), message));
              }
            });
    return found;
  }

  private List<Diagnostic> judge(
      Property property, List<Map<String, JsonNode>> samples, List<CallResults> results) {
    JsonNode before = null;
    for (int i = 0; i < results.size(); i++) {
      if (results.get(i).problem().isPresent()) {
        return failed(property, problem(results.get(i).problem().get()));
      }
      JsonNode value = results.get(i).outputs().get(0).path(property.output());
      String here = is(property, value) + "%s with " + shown(samples.get(i));
      if (!isAccepted(property, value)) {
        String wanted = property.bounds().map(TestExpectation::words).orElse("a number");
        return failed(property, here.formatted(", not " + wanted + ",") + ".");
      }
      boolean first = i % SAMPLES == 0; // the other inputs have changed
      if (!first && isAgainst(property.kind(), before, value)) {
        String earlier = ", and was %s with %s.".formatted(before, shown(samples.get(i - 1)));
        return failed(property, here.formatted("") + earlier);
      }
      before = value;
    }
    return List.of();
  }

  private static boolean isAccepted(Property property, JsonNode value) {
    return property.bounds().map(each -> each.accepts(value)).orElse(value.isNumber());
  }

  private static String problem(Diagnostic problem) {
    return problem.message() + " It was in line " + problem.location().line() + ".";
  }

  private static boolean isAgainst(Kind kind, JsonNode before, JsonNode value) {
    double change = value.asDouble() - before.asDouble();
    return kind == Kind.RISES ? change < 0 : kind == Kind.FALLS && change > 0;
  }

  private static String is(Property property, JsonNode value) {
    return "'%s' is %s".formatted(property.output(), shortened(value.toString()));
  }

  private static List<Diagnostic> failed(Property property, String message) {
    return List.of(failed(property.name(), property.requirement(), property.place(), message));
  }

  private static Diagnostic failed(
      String test, String requirement, SourceLocation place, String message) {
    return Diagnostic.of(
            TestRules.TEST_FAILED,
            "The test '%s' of %s fails: %s".formatted(test, requirement, message),
            place)
        .withHint(
            "Correct the component; or the test, if it asks for something that is not wanted.");
  }

  /**
   * Checks that the first test gives the same result again: state outside the object would change
   * it.
   */
  private static List<Diagnostic> sameAgain(Case test, CallResults first, CallResults again) {
    return again.problem().isEmpty() && first.outputs().equals(again.outputs())
        ? List.of()
        : List.of(
            Diagnostic.of(
                    ComponentRules.STATE_SHARED,
                    "The test '%s' on a new component gives other outputs after the other tests."
                            .formatted(test.name())
                        + " The component keeps state outside of its object.",
                    test.place())
                .withHint("Keep all state in attributes that __init__ sets."));
  }

  private List<ComponentCall> calls(String name, List<Map<String, JsonNode>> inputs) {
    return inputs.stream().map(each -> new ComponentCall(name, arguments(each))).toList();
  }

  private Map<String, Object> arguments(Map<String, JsonNode> inputs) {
    Map<String, Object> arguments = new LinkedHashMap<>();
    for (Value input : component.inputValues()) {
      try {
        arguments.put(input.name(), TestValues.of(inputs.get(input.name()), input.type()));
      } catch (TestValues.Unfit e) {
        throw new IllegalArgumentException("the reader refuses such tests", e);
      }
    }
    return arguments;
  }

  /** Returns samples of the inputs. The monotonic input varies fastest, then the others in turn. */
  private List<Map<String, JsonNode>> samples(Property property) {
    List<String> varied = new ArrayList<>(property.over().keySet());
    if (property.kind() != Kind.RANGE) {
      varied.remove(property.input());
      varied.add(0, property.input());
    }
    List<Map<String, JsonNode>> samples = List.of(property.inputs());
    int size = SAMPLES;
    for (int i = varied.size() - 1; i >= 0; i--) {
      // All values of one input, and the ends and the middle of the others.
      size = i == 0 ? SAMPLES : 3;
      samples = crossed(samples, varied.get(i), property.over().get(varied.get(i)), size);
    }
    return samples;
  }

  private List<Map<String, JsonNode>> crossed(
      List<Map<String, JsonNode>> samples, String input, double[] range, int size) {
    boolean whole =
        component.inputValues().stream()
            .anyMatch(
                value -> value.name().equals(input) && !value.type().matches("float.*|double"));
    List<Map<String, JsonNode>> crossed = new ArrayList<>();
    for (Map<String, JsonNode> sample : samples) {
      for (int i = 0; i < size; i++) {
        double value = range[0] + (range[1] - range[0]) * i / (size - 1);
        Map<String, JsonNode> more = new LinkedHashMap<>(sample);
        more.put(input, DoubleNode.valueOf(whole ? Math.rint(value) : value));
        crossed.add(more);
      }
    }
    return crossed;
  }

  private static String shown(Map<String, JsonNode> inputs) {
    List<String> parts = new ArrayList<>();
    inputs.forEach((name, value) -> parts.add(name + " = " + shortened(value.toString())));
    return String.join(", ", parts);
  }

  private static String shortened(String text) {
    return text.length() > LONGEST_VALUE ? text.substring(0, LONGEST_VALUE) + "..." : text;
  }
}
