package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.SourceLocation;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** All combinations of deterministic distributions, in the order of their file. */
final class DeterministicCases {

  private static final int MOST_DIGITS = 400;
  private static final BigInteger MOST = BigInteger.valueOf(Variations.MOST);

  private final VariedParameters parameters;
  private final List<List<Map<String, String>>> dimensions = new ArrayList<>();
  private BigInteger count = BigInteger.ONE;

  DeterministicCases(ScenarioFile scenario, Findings findings) {
    this.parameters = new VariedParameters(scenario, findings);
  }

  /** Returns the cases; none, with findings, if a distribution is wrong or they are too many. */
  List<Map<String, String>> of(ScenarioElement deterministic) {
    if (deterministic.children().isEmpty()) {
      parameters.wrong(
          "`Deterministic` has no distributions.", deterministic.location(), "Add one.");
    }
    for (ScenarioElement each : deterministic.children()) {
      if (each.name().equals("DeterministicMultiParameterDistribution")) {
        sets(each.required("ValueSetDistribution"));
      } else {
        single(each.text("parameterName"), each.choice(), each.location("parameterName"));
      }
    }
    return parameters.areFew(count, deterministic.location()) ? product() : List.of();
  }

  private List<Map<String, String>> product() {
    List<Map<String, String>> cases = new ArrayList<>();
    for (int i = 0; i < count.intValue(); i++) {
      Map<String, String> values = new LinkedHashMap<>();
      int among = count.intValue();
      for (List<Map<String, String>> dimension : dimensions) {
        among /= dimension.size();
        values.putAll(dimension.get(i / among % dimension.size()));
      }
      cases.add(values);
    }
    return cases;
  }

  private void sets(ScenarioElement distribution) {
    List<Map<String, String>> sets = new ArrayList<>();
    for (ScenarioElement set : distribution.children("ParameterValueSet")) {
      Map<String, String> values = new LinkedHashMap<>();
      for (ScenarioElement each : set.children("ParameterAssignment")) {
        String name = each.text("parameterRef");
        parameters.check(name, each.text("value"), each.location("value"));
        if (values.put(name, each.text("value")) != null) {
          parameters.wrong("`" + name + "` has two values.", each.location(), "Leave one out.");
        }
      }
      sets.add(values);
    }
    List<String> names = sets.stream().flatMap(set -> set.keySet().stream()).distinct().toList();
    names.forEach(name -> parameters.vary(name, distribution.location()));
    add(sets);
  }

  private void single(String name, ScenarioElement distribution, SourceLocation place) {
    parameters.vary(name, place);
    if (distribution.name().equals("UserDefinedDistribution")) {
      parameters.userDefined(distribution);
    } else if (distribution.name().equals("DistributionRange")) {
      parameters
          .typeOf(name, place)
          .ifPresent(
              type -> {
                if (type.isNumber()) {
                  range(name, distribution);
                } else {
                  parameters.wrong(
                      "`" + name + "` is " + type.description() + ", which has no range.",
                      distribution.location(),
                      "Use a `DistributionSet`.");
                }
              });
    } else {
      List<Map<String, String>> values = new ArrayList<>();
      for (ScenarioElement each : distribution.children("Element")) {
        parameters.check(name, each.text("value"), each.location("value"));
        values.add(Map.of(name, each.text("value")));
      }
      add(values);
    }
  }

  private void add(List<Map<String, String>> values) {
    count = count.multiply(BigInteger.valueOf(values.size()));
    dimensions.add(values);
  }

  private void range(String name, ScenarioElement distribution) {
    ScenarioElement range = distribution.required("Range");
    if (Double.isInfinite(range.number("lowerLimit") - range.number("upperLimit"))) {
      parameters.wrong("The range has no end.", range.location(), "Give it two numbers.");
      return;
    }
    BigDecimal lower = new BigDecimal(range.text("lowerLimit"));
    BigDecimal upper = new BigDecimal(range.text("upperLimit"));
    BigDecimal step = new BigDecimal(distribution.text("stepWidth"));
    if (!Stream.of(lower, upper, step).allMatch(DeterministicCases::isComputable)) {
      parameters.wrong(
          "The range has a number with hundreds of digits.", distribution.location(), "Round it.");
      return;
    } else if (step.signum() <= 0 || lower.compareTo(upper) > 0) {
      parameters.wrong(
          "No steps of " + step + " lead from " + lower + " to " + upper + ".",
          distribution.location(),
          "The lower limit comes first, and a step is greater than 0.");
      return;
    }
    steps(name, lower, upper, step, distribution.location());
  }

  /** Adds the values of a range, unless there would be too many cases. */
  private void steps(
      String name, BigDecimal lower, BigDecimal upper, BigDecimal step, SourceLocation place) {
    BigInteger steps = upper.subtract(lower).divide(step, 0, RoundingMode.DOWN).toBigInteger();
    BigInteger all = count.multiply(steps.add(BigInteger.ONE));
    if (all.compareTo(MOST) > 0) {
      count = all;
      return;
    }
    List<Map<String, String>> values = new ArrayList<>();
    for (BigDecimal value = lower; value.compareTo(upper) <= 0; value = value.add(step)) {
      String text = value.signum() == 0 ? "0" : value.stripTrailingZeros().toPlainString();
      parameters.check(name, text, place);
      values.add(Map.of(name, text));
    }
    add(values);
  }

  /** Returns whether a number has so few digits that sums with it are computed at once. */
  private static boolean isComputable(BigDecimal number) {
    return Math.abs(number.scale()) <= MOST_DIGITS && number.precision() <= MOST_DIGITS;
  }
}
