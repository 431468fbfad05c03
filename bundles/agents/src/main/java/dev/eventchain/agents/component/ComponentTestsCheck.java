package dev.eventchain.agents.component;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.agents.chain.ChainView.Component;
import dev.eventchain.agents.chain.ChainView.Value;
import dev.eventchain.agents.component.ComponentTests.Case;
import dev.eventchain.agents.component.ComponentTests.Property;
import dev.eventchain.agents.component.RequirementThresholds.Threshold;
import dev.eventchain.description.ChainNames;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.project.Requirements;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;

/**
 * Checks tests against requirements: each test names an existing requirement and does not
 * contradict its thresholds, and all requirements and thresholds of the component are tested.
 */
final class ComponentTestsCheck {
  private static final Pattern NORMALIZED =
      Pattern.compile("(?i)normali[sz]ed|\\b0(\\.0)? to 1(\\.0)?\\b");

  /** Magnitude below which an output counts as zero, as a tolerance for rounding. */
  private static final double ZERO = 1e-5;

  private final Component component;
  private final Map<String, WrittenRequirement> requirements = new LinkedHashMap<>();
  private final Map<WrittenRequirement, List<Threshold>> thresholds = new HashMap<>();
  private final boolean isNormalized;

  /**
   * Creates a check for the tests of a component.
   *
   * @param requirements all requirements of the project; the chain names those of the component
   */
  ComponentTestsCheck(Component component, Requirements requirements) {
    this.component = component;
    requirements.items().forEach(item -> this.requirements.put(item.id(), item));
    this.isNormalized =
        requirements.items().stream().anyMatch(item -> NORMALIZED.matcher(item.text()).find());
  }

  /** Returns the errors in the tests. */
  List<Diagnostic> wrong(ComponentTests tests) {
    List<Diagnostic> found = new ArrayList<>();
    Set<String> names = new TreeSet<>();
    for (Case test : tests.tests()) {
      named(test.requirement(), test.name(), test.place(), names, found);
      contradiction(test).ifPresent(found::add);
    }
    for (Property property : tests.properties()) {
      named(property.requirement(), property.name(), property.place(), names, found);
    }
    return found;
  }

  private void named(
      String requirement,
      String name,
      SourceLocation place,
      Set<String> names,
      List<Diagnostic> found) {
    if (!requirements.containsKey(requirement)) {
      found.add(
          Diagnostic.of(
                  TestRules.TESTS_REQUIREMENT,
                  "There is no requirement '%s'.".formatted(requirement),
                  place)
              .withHint(NearestName.hint(requirement, requirements.keySet())));
    }
    if (!names.add(name)) {
      found.add(
          Diagnostic.of(
              ComponentTestsReader.FORMAT,
              "Another test is already called '%s'.".formatted(name),
              place));
    }
  }

  private Optional<Diagnostic> contradiction(Case test) {
    WrittenRequirement requirement = requirements.get(test.requirement());
    if (requirement == null) {
      return Optional.empty();
    }
    for (Threshold threshold : thresholds(requirement)) {
      if (isAlwaysIn(threshold, test)) {
        for (String output : threshold.outputs()) {
          TestExpectation expected = test.outputs().get(output);
          if (expected != null && !isState(output) && !isPossible(threshold.effect(), expected)) {
            return Optional.of(contradiction(test, threshold, output, expected));
          }
        }
      }
    }
    return Optional.empty();
  }

  private static Diagnostic contradiction(
      Case test, Threshold threshold, String output, TestExpectation expected) {
    return Diagnostic.of(
            TestRules.TESTS_CONTRADICTION,
            "'%s' expects '%s' to be %s, but %s says \"%s\"."
                .formatted(
                    test.name(), output, expected.words(), test.requirement(), threshold.clause()),
            test.place())
        .withHint("Correct the expected output, the input, or the requirement.");
  }

  /**
   * Returns whether an input stays in the range of a threshold; a changing value may have crossed
   * it.
   */
  private static boolean isAlwaysIn(Threshold threshold, Case test) {
    return test.calls().stream()
        .map(call -> literal(call.get(threshold.input())))
        .allMatch(value -> value.isPresent() && threshold.holds(value.getAsDouble()));
  }

  private static OptionalDouble literal(JsonNode written) {
    return written == null
        ? OptionalDouble.empty()
        : TestValues.literal(written).map(OptionalDouble::of).orElse(OptionalDouble.empty());
  }

  /** Returns whether an output is a whole number, of which 0 may be any state. */
  private boolean isState(String output) {
    return component.outputValues().stream()
        .anyMatch(value -> value.name().equals(output) && ThresholdGaps.isWhole(value.type()));
  }

  private boolean isPossible(ThresholdEffect effect, TestExpectation expected) {
    Optional<JsonNode> exact = expected.exact();
    if (effect != ThresholdEffect.UNKNOWN && exact.isPresent() && exact.get().isBoolean()) {
      return exact.get().asBoolean() == (effect != ThresholdEffect.NONE);
    }
    double least = expected.smallest();
    double most = expected.greatest();
    if (Double.isNaN(least) || Double.isNaN(most)) {
      return true; // a text or an array, about which no threshold is known
    }
    boolean zero = least <= 0 && most >= 0;
    boolean onlyZero = zero && Math.max(-least, most) <= ZERO;
    return switch (effect) {
      case NONE -> zero;
      case SOME -> !onlyZero;
      case FULL -> isNormalized ? least <= 1 && most >= 1 : !onlyZero;
      case PARTIAL -> !onlyZero && (!isNormalized || (least < 1 - ZERO && most > ZERO));
      case UNKNOWN -> true;
    };
  }

  /** Returns the gaps of the tests, as a finding at a place of the tests. */
  Optional<Diagnostic> gaps(ComponentTests tests, SourceLocation place) {
    List<String> missing = new ArrayList<>();
    Set<String> tested = new TreeSet<>();
    tests.tests().forEach(test -> tested.add(test.requirement()));
    tests.properties().forEach(property -> tested.add(property.requirement()));
    for (JsonNode id : component.json().path(ChainNames.REQUIREMENTS)) {
      if (requirements.containsKey(id.asText()) && !tested.contains(id.asText())) {
        missing.add("about " + id.asText());
      }
    }
    changes().forEach((input, bounds) -> missing.addAll(gaps(input, bounds, tests)));
    return missing.isEmpty()
        ? Optional.empty()
        : Optional.of(
            Diagnostic.of(
                    TestRules.TESTS_GAP,
                    "No test is " + String.join(", none ", missing) + ".",
                    place)
                .withHint(
                    "Add them; just below and just above mean at most a tenth of the value away"
                        + (missing.stream().anyMatch(ThresholdGaps::statesDistance)
                            ? ", where nothing else is said."
                            : ".")));
  }

  /** Returns the thresholds of a requirement, which is parsed once. */
  private List<Threshold> thresholds(WrittenRequirement requirement) {
    return thresholds.computeIfAbsent(
        requirement, each -> RequirementThresholds.of(each, component));
  }

  /** Returns the values of inputs at which a requirement of the component changes its effect. */
  private Map<String, Set<Double>> changes() {
    Map<String, Set<Double>> changes = new LinkedHashMap<>();
    for (JsonNode id : component.json().path(ChainNames.REQUIREMENTS)) {
      Optional.ofNullable(requirements.get(id.asText())).stream()
          .flatMap(item -> thresholds(item).stream())
          .forEach(
              each ->
                  changes
                      .computeIfAbsent(each.input(), input -> new TreeSet<>())
                      .addAll(each.bounds()));
    }
    return changes;
  }

  private List<String> gaps(String input, Set<Double> bounds, ComponentTests tests) {
    List<Double> values =
        tests.tests().stream()
            .map(test -> literal(test.calls().get(test.calls().size() - 1).get(input)))
            .filter(OptionalDouble::isPresent)
            .map(OptionalDouble::getAsDouble)
            .toList();
    String type =
        component.inputValues().stream()
            .filter(value -> value.name().equals(input))
            .map(Value::type)
            .findFirst()
            .orElseThrow();
    return bounds.stream()
        .flatMap(bound -> new ThresholdGaps(type, bound, bounds).in(values, input).stream())
        .toList();
  }
}
