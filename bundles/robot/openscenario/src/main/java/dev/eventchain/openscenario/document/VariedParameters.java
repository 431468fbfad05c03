package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.openscenario.vocabulary.DataType;
import java.math.BigInteger;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** The parameters of a scenario that distributions name. */
final class VariedParameters {

  private static final BigInteger MOST = BigInteger.valueOf(Variations.MOST);
  private static final long MOST_VALUES = 10_000_000;

  private final Map<String, DataType> declared = new LinkedHashMap<>();
  private final Set<String> varied = new HashSet<>();
  private final Findings findings;

  VariedParameters(ScenarioFile scenario, Findings findings) {
    this.findings = findings;
    for (ParameterDeclaration each : scenario.parameters()) {
      declared.putIfAbsent(each.name(), DataType.ofWord(each.type()).orElseThrow());
    }
  }

  /** Returns the type of a parameter; empty, with a finding, if it is not declared. */
  Optional<DataType> typeOf(String name, SourceLocation place) {
    if (!declared.containsKey(name)) {
      findings.add(
          DocumentRules.PARAMETER_UNKNOWN,
          "The scenario declares no parameter `" + name + "`.",
          place,
          NearestName.hint(name, declared.keySet()));
    }
    return Optional.ofNullable(declared.get(name));
  }

  /** Notes that a distribution varies a parameter, which another one may not. */
  void vary(String name, SourceLocation place) {
    if (!varied.add(name)) {
      wrong("Two distributions vary `" + name + "`.", place, "Leave one out.");
    }
  }

  /** Checks a value of a parameter. */
  void check(String name, String value, SourceLocation place) {
    typeOf(name, place)
        .ifPresent(type -> AttributeValues.check(type, name, value, place, findings));
  }

  void wrong(String message, SourceLocation place, String hint) {
    findings.add(DocumentRules.DISTRIBUTION, message, place, hint);
  }

  /** Refuses what only its author can read. */
  void userDefined(ScenarioElement distribution) {
    findings.add(
        DocumentRules.DISTRIBUTION_UNSUPPORTED,
        "A `UserDefinedDistribution` has values that the standard does not say.",
        distribution.location(),
        "Write them as one of the standard's distributions.");
  }

  /** Returns whether so many cases can be made; reports it otherwise. */
  boolean areFew(BigInteger cases, SourceLocation place) {
    boolean few = cases.compareTo(MOST) <= 0;
    String count = cases.bitLength() < Long.SIZE ? cases.toString() : "more than 2^63";
    if (!few) {
      findings.add(
          DocumentRules.DISTRIBUTION_SIZE,
          "There would be " + count + " cases; at most " + MOST + " are made.",
          place,
          "Use wider steps, fewer values or fewer runs.");
    } else if (cases.longValue() * varied.size() > MOST_VALUES) {
      findings.add(
          DocumentRules.DISTRIBUTION_SIZE,
          cases
              + " cases would have "
              + varied.size()
              + " values each; at most "
              + MOST_VALUES
              + " values are made.",
          place,
          "Vary fewer parameters, or make fewer cases.");
      few = false;
    }
    return few;
  }
}
