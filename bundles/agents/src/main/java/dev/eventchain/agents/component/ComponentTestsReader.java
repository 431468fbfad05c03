package dev.eventchain.agents.component;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.agents.chain.ChainView.Component;
import dev.eventchain.agents.chain.ChainView.Value;
import dev.eventchain.agents.component.ComponentTests.Case;
import dev.eventchain.agents.component.ComponentTests.Kind;
import dev.eventchain.agents.component.ComponentTests.Property;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/** Reads the tests of a component, and refuses those that do not match it. */
final class ComponentTestsReader {
  static final Rule FORMAT = TestRules.TESTS_FORMAT;
  private static final DocumentRules RULES = DocumentRules.all(FORMAT);
  private static final NumberRange REPEATS = NumberRange.of(1, 10_000);
  private static final NumberRange ANY = NumberRange.of(-Double.MAX_VALUE, Double.MAX_VALUE);

  /** Maximal number of calls of one test. */
  private static final int MOST_CALLS = 10_000;

  /** Maximal number of input values of one test, counting elements of arrays. */
  private static final int MOST_VALUES = 5_000_000;

  private static final int MOST_VARIED = 4;

  private final Map<String, Value> inputs;
  private final Map<String, Value> outputs;
  private final String component;
  private final Consumer<Diagnostic> findings;

  private ComponentTestsReader(Component component, Consumer<Diagnostic> findings) {
    this.component = component.name();
    this.inputs = byName(component.inputValues());
    this.outputs = byName(component.outputValues());
    this.findings = findings;
  }

  private static Map<String, Value> byName(List<Value> values) {
    return values.stream()
        .collect(Collectors.toMap(Value::name, value -> value, (a, b) -> a, LinkedHashMap::new));
  }

  /**
   * Reads tests.
   *
   * @param findings receives the errors; invalid parts are left out
   */
  static ComponentTests read(
      SourceText text, DocumentFormat format, Component component, Consumer<Diagnostic> findings) {
    ComponentTestsReader reader = new ComponentTestsReader(component, findings);
    return Document.parse(text, format, RULES, findings)
        .object("", findings)
        .map(reader::read)
        .orElseGet(() -> new ComponentTests(List.of(), List.of()));
  }

  private ComponentTests read(ObjectReader file) {
    file.text("component")
        .filter(name -> !name.equals(component))
        .ifPresent(
            name ->
                file.find(
                    FORMAT,
                    "These tests are for '%s', not for '%s'.".formatted(name, component),
                    file.at("component")));
    List<Case> tests = file.objects("tests").stream().flatMap(test -> test(test).stream()).toList();
    List<Property> properties =
        file.objects("properties").stream().flatMap(each -> property(each).stream()).toList();
    file.refuseOthers();
    return new ComponentTests(tests, properties);
  }

  private Optional<Case> test(ObjectReader test) {
    String name = test.requiredText("name");
    String requirement = test.requiredText("requirement");
    List<Map<String, JsonNode>> calls = test.has("steps") ? steps(test) : single(test);
    Optional<ExpectedError> raises = test.object("raises").map(ExpectedError::read);
    Map<String, TestExpectation> expected =
        test.has("raises") && !test.has("outputs") ? Map.of() : expectations(test);
    if (test.has("raises") && test.has("outputs")) {
      test.find(FORMAT, "A call that raises has no outputs.", test.at("raises"));
    }
    test.refuseOthers();
    if (calls.size() > MOST_CALLS || values(calls) > MOST_VALUES) {
      String message =
          String.format(
              Locale.ROOT,
              "A test has at most %d calls, with %d values in all.",
              MOST_CALLS,
              MOST_VALUES);
      test.find(FORMAT, message, test.location());
      return Optional.empty();
    }
    return calls.isEmpty() || (expected.isEmpty() && raises.isEmpty())
        ? Optional.empty()
        : Optional.of(new Case(name, requirement, calls, expected, raises, test.location()));
  }

  private static long values(List<Map<String, JsonNode>> calls) {
    return calls.stream()
        .flatMap(call -> call.values().stream())
        .mapToLong(value -> value.isArray() ? value.size() : value.path("count").asLong(1))
        .sum();
  }

  private List<Map<String, JsonNode>> single(ObjectReader test) {
    return test.requiredObject("inputs")
        .map(given -> List.of(inCall(complete(given, Map.of()), 0)))
        .orElse(List.of());
  }

  /** Reads the steps; inputs that a step omits are as in the previous step. */
  private List<Map<String, JsonNode>> steps(ObjectReader test) {
    List<Map<String, JsonNode>> calls = new ArrayList<>();
    Map<String, JsonNode> before = Map.of();
    for (ObjectReader step : test.requiredObjects("steps")) {
      long repeat = step.wholeNumber("repeat", REPEATS).orElse(1);
      Optional<ObjectReader> given = step.requiredObject("inputs");
      step.refuseOthers();
      if (given.isPresent()) {
        Map<String, JsonNode> written = complete(given.get(), before);
        for (int i = 0; i < repeat && calls.size() <= MOST_CALLS; i++) {
          before = inCall(written, i);
          calls.add(before);
        }
      }
    }
    return calls;
  }

  private static Map<String, JsonNode> inCall(Map<String, JsonNode> written, int call) {
    Map<String, JsonNode> values = new LinkedHashMap<>();
    written.forEach((name, value) -> values.put(name, TestValues.inCall(value, call)));
    return values;
  }

  /** Returns the inputs of a call: those given, and otherwise those of the previous call. */
  private Map<String, JsonNode> complete(ObjectReader given, Map<String, JsonNode> before) {
    Map<String, JsonNode> complete = new LinkedHashMap<>();
    inputs.forEach(
        (name, input) -> {
          if (given.has(name)) {
            JsonNode written = given.value(name).orElseThrow();
            requireFit(given, input, written);
            complete.put(name, written);
          } else if (before.containsKey(name)) {
            complete.put(name, before.get(name));
          } else {
            given.find(FORMAT, "There is no value for the input '" + name + "'.", given.location());
          }
        });
    given.refuseOthers();
    return complete;
  }

  private static void requireFit(ObjectReader given, Value input, JsonNode written) {
    try {
      TestValues.of(TestValues.inCall(written, 0), input.type());
    } catch (TestValues.Unfit e) {
      given.find(
          FORMAT,
          "'%s' is %s: write %s.".formatted(input.name(), input.type(), e.getMessage()),
          given.at(input.name()));
    }
  }

  private Map<String, TestExpectation> expectations(ObjectReader test) {
    Map<String, TestExpectation> expected = new LinkedHashMap<>();
    test.requiredObject("outputs")
        .ifPresent(
            given -> {
              for (String name : outputs.keySet()) {
                expectation(given, name).ifPresent(each -> expected.put(name, each));
              }
              given.refuseOthers();
              if (given.names().isEmpty()) {
                given.find(FORMAT, "Nothing is expected of any output.", given.location());
              }
            });
    return expected;
  }

  private Optional<TestExpectation> expectation(ObjectReader given, String name) {
    Optional<JsonNode> value = given.value(name);
    if (value.isEmpty()) {
      return Optional.empty();
    }
    Optional<TestExpectation> expected =
        value.get().isObject() && !value.get().has("count")
            ? given.object(name).flatMap(TestExpectation::read)
            : Optional.of(TestExpectation.exactly(value.get()));
    expected.ifPresent(each -> requirePossible(given, outputs.get(name), each, given.at(name)));
    return expected;
  }

  /** Reports an expectation that no value of the output's type meets. */
  private static void requirePossible(
      ObjectReader object, Value output, TestExpectation expected, SourceLocation place) {
    try {
      if (expected.isNumeric()) {
        TestValues.requireNumber(output.type());
      } else {
        TestValues.requireConstant(expected.exact().orElseThrow(), output.type());
      }
    } catch (TestValues.Unfit e) {
      object.find(
          FORMAT,
          "No component can pass this: '%s' is %s, so expect %s."
              .formatted(output.name(), output.type(), e.getMessage()),
          place);
    }
  }

  private Optional<Property> property(ObjectReader property) {
    String name = property.requiredText("name");
    String requirement = property.requiredText("requirement");
    String output = known(property, "output", outputs);
    Kind kind = kind(property);
    String input = kind == Kind.RANGE ? "" : known(property, kind.key(), inputs);
    Optional<TestExpectation> bounds =
        kind == Kind.RANGE
            ? property.requiredObject("within").flatMap(TestExpectation::read)
            : Optional.empty();
    Map<String, double[]> over = over(property);
    Map<String, JsonNode> others = others(property, over);
    property.refuseOthers();
    if (outputs.containsKey(output)) {
      requireOrder(property, outputs.get(output), kind, bounds);
    }
    boolean isVaried = kind == Kind.RANGE || over.containsKey(input);
    if (!isVaried) {
      property.find(
          FORMAT, "'over' does not give the range of '" + input + "'.", property.location());
    }
    boolean isWhole = !output.isEmpty() && !over.isEmpty() && isVaried;
    return isWhole && (kind != Kind.RANGE || bounds.isPresent())
        ? Optional.of(
            new Property(
                name, requirement, kind, output, bounds, input, over, others, property.location()))
        : Optional.empty();
  }

  /** Reports a property that no output of this type can have. */
  private static void requireOrder(
      ObjectReader property, Value output, Kind kind, Optional<TestExpectation> bounds) {
    if (kind == Kind.RANGE) {
      bounds.ifPresent(each -> requirePossible(property, output, each, property.at("within")));
    } else if (!TestValues.isNumber(output.type())) {
      property.find(
          Diagnostic.of(
                  FORMAT,
                  "No component can pass this: '%s' is %s, which neither rises nor falls."
                      .formatted(output.name(), output.type()),
                  property.at(kind.key()))
              .withHint("Write tests on both sides of where it changes, or 'within' a 'value'."));
    }
  }

  private static Kind kind(ObjectReader property) {
    if (property.has(Kind.RISES.key())) {
      return Kind.RISES;
    }
    return property.has(Kind.FALLS.key()) ? Kind.FALLS : Kind.RANGE;
  }

  private String known(ObjectReader object, String key, Map<String, Value> values) {
    String name = object.requiredText(key);
    if (!name.isEmpty() && !values.containsKey(name)) {
      unknown(object.at(key), name, values);
      return "";
    }
    return name;
  }

  private void unknown(SourceLocation place, String name, Map<String, Value> values) {
    findings.accept(
        Diagnostic.of(FORMAT, "'%s' has no '%s'.".formatted(component, name), place)
            .withHint(NearestName.hint(name, values.keySet())));
  }

  private Map<String, double[]> over(ObjectReader property) {
    Map<String, double[]> over = new LinkedHashMap<>();
    property
        .requiredObject("over")
        .ifPresent(
            ranges -> {
              if (ranges.names().size() > MOST_VARIED) {
                String message = "At most " + MOST_VARIED + " inputs are varied at a time.";
                ranges.find(FORMAT, message, ranges.location());
                return;
              }
              for (String name : ranges.names()) {
                ranges.object(name).ifPresent(range -> over.put(name, range(range, name)));
              }
            });
    return over;
  }

  private double[] range(ObjectReader range, String name) {
    double from = range.requiredNumber("from", ANY);
    double to = range.requiredNumber("to", ANY);
    range.refuseOthers();
    if (!inputs.containsKey(name)) {
      unknown(range.location(), name, inputs);
    } else if (!TestValues.isNumber(inputs.get(name).type()) || from >= to) {
      range.find(
          FORMAT,
          "A varied input must be a number, and its range must go from a lower to a higher one.",
          range.location());
    }
    return new double[] {from, to};
  }

  private Map<String, JsonNode> others(ObjectReader property, Map<String, double[]> over) {
    Map<String, JsonNode> others = new LinkedHashMap<>();
    Optional<ObjectReader> given = property.object("inputs");
    inputs.forEach(
        (name, input) -> {
          Optional<JsonNode> written =
              over.containsKey(name)
                  ? Optional.empty()
                  : given.filter(each -> each.has(name)).flatMap(each -> each.value(name));
          if (written.isPresent()) {
            requireFit(given.get(), input, written.get());
            others.put(name, written.get());
          } else if (!over.containsKey(name)) {
            property.find(
                FORMAT, "There is no value for the input '" + name + "'.", property.location());
          }
        });
    given.ifPresent(ObjectReader::refuseOthers);
    return others;
  }
}
