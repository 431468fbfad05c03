package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.openscenario.distribution.Distribution;
import dev.eventchain.openscenario.distribution.Draws;
import dev.eventchain.openscenario.distribution.Limits;
import dev.eventchain.openscenario.vocabulary.DataType;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;

/** Draws of stochastic distributions. The same file gives the same draws on each machine. */
final class StochasticCases {

  private static final double LARGEST_POISSON_MEAN = 1000;

  private final VariedParameters parameters;
  private final Map<String, Distribution> distributions = new LinkedHashMap<>();

  StochasticCases(ScenarioFile scenario, Findings findings) {
    this.parameters = new VariedParameters(scenario, findings);
  }

  /** Returns the cases; none, with findings, if a distribution is wrong or they are too many. */
  List<Map<String, String>> of(ScenarioElement stochastic) {
    long runs = Long.parseLong(stochastic.text("numberOfTestRuns"));
    SourceLocation place = stochastic.location("numberOfTestRuns");
    if (runs == 0) {
      parameters.wrong("`Stochastic` has no runs.", place, "Ask for one.");
    }
    boolean complete = true;
    for (ScenarioElement each : stochastic.children("StochasticDistribution")) {
      complete &= add(each.text("parameterName"), each.choice(), each.location("parameterName"));
    }
    complete &= parameters.areFew(BigInteger.valueOf(runs), place);
    return complete ? draw((int) runs, stochastic) : List.of();
  }

  private List<Map<String, String>> draw(int runs, ScenarioElement stochastic) {
    double seed = stochastic.number("randomSeed", 0);
    Map<String, Random> randoms = new LinkedHashMap<>();
    distributions.keySet().forEach(name -> randoms.put(name, Draws.of(seed, name)));
    List<Map<String, String>> cases = new ArrayList<>();
    for (int run = 0; run < runs; run++) {
      Map<String, String> values = new LinkedHashMap<>();
      for (Map.Entry<String, Distribution> each : distributions.entrySet()) {
        Optional<String> value = each.getValue().draw(randoms.get(each.getKey()));
        if (value.isEmpty()) {
          parameters.wrong(
              "Hardly any value of `" + each.getKey() + "` is within its range.",
              stochastic.location(),
              "Give it a range in which its values are.");
          return List.of();
        }
        values.put(each.getKey(), value.get());
      }
      cases.add(values);
    }
    return cases;
  }

  /** Adds a distribution, if it can be read. */
  private boolean add(String name, ScenarioElement distribution, SourceLocation place) {
    parameters.vary(name, place);
    Optional<DataType> type = parameters.typeOf(name, place);
    boolean listed = distribution.name().equals("ProbabilityDistributionSet");
    boolean counts = distribution.name().equals("PoissonDistribution");
    if (distribution.name().equals("UserDefinedDistribution")) {
      parameters.userDefined(distribution);
      return false;
    } else if (type.isPresent()
        && !listed
        && !(counts && type.get().isNumber())
        && type.get() != DataType.DOUBLE) {
      parameters.wrong(
          "`" + name + "` is " + type.get().description() + ", but the values have fractions.",
          distribution.location(),
          "Use a `ProbabilityDistributionSet`.");
      return false;
    }
    Optional<Distribution> read = read(name, distribution);
    read.ifPresent(each -> distributions.put(name, each));
    return read.isPresent() && type.isPresent();
  }

  private Optional<Distribution> read(String name, ScenarioElement written) {
    Optional<Limits> limits = limits(written);
    if (limits.isEmpty()) {
      return Optional.empty();
    }
    return switch (written.name()) {
      case "ProbabilityDistributionSet" -> weighted(name, written.children("Element"));
      case "Histogram" -> histogram(written);
      case "UniformDistribution" ->
          bounded(written.required("Range")).map(Distribution.Histogram::uniform);
      case "PoissonDistribution" -> poisson(written, limits.get());
      default -> normal(written, limits.get());
    };
  }

  /** Returns the range of a distribution; empty, with a finding, if it has none in it. */
  private Optional<Limits> limits(ScenarioElement written) {
    Optional<ScenarioElement> range = written.child("Range");
    Limits limits =
        range
            .map(each -> new Limits(each.number("lowerLimit"), each.number("upperLimit")))
            .orElse(Limits.NONE);
    if (limits.lower() > limits.upper()) {
      parameters.wrong(
          "The range ends at " + limits.upper() + ", before it begins at " + limits.lower() + ".",
          range.orElseThrow().location(),
          "The lower limit comes first.");
      return Optional.empty();
    }
    return Optional.of(limits);
  }

  private Optional<Limits> bounded(ScenarioElement range) {
    Limits limits = new Limits(range.number("lowerLimit"), range.number("upperLimit"));
    if (Double.isInfinite(limits.lower()) || Double.isInfinite(limits.upper())) {
      parameters.wrong("The range has no end.", range.location(), "Give it two numbers.");
      return Optional.empty();
    }
    return Optional.of(limits);
  }

  private Optional<Distribution> weighted(String name, List<ScenarioElement> elements) {
    List<String> values = new ArrayList<>();
    for (ScenarioElement each : elements) {
      parameters.check(name, each.text("value"), each.location("value"));
      values.add(each.text("value"));
    }
    return weights(elements).map(weights -> new Distribution.Weighted(values, weights));
  }

  private Optional<Distribution> histogram(ScenarioElement written) {
    List<Limits> bins = new ArrayList<>();
    List<ScenarioElement> elements = written.children("Bin");
    for (ScenarioElement bin : elements) {
      if (limits(bin).isPresent()) {
        bounded(bin.required("Range")).ifPresent(bins::add);
      }
    }
    return bins.size() < elements.size()
        ? Optional.empty()
        : weights(elements).map(weights -> new Distribution.Histogram(bins, weights));
  }

  private Optional<List<Double>> weights(List<ScenarioElement> elements) {
    List<Double> weights = elements.stream().map(each -> each.number("weight")).toList();
    double sum = weights.stream().mapToDouble(weight -> weight).sum();
    boolean positive = weights.stream().allMatch(weight -> weight >= 0);
    if (!positive || sum <= 0 || Double.isInfinite(sum)) {
      parameters.wrong(
          "The weights are no probabilities.",
          elements.get(0).location("weight"),
          "None is negative, and one is greater than 0.");
      return Optional.empty();
    }
    return Optional.of(weights);
  }

  private Optional<Distribution> poisson(ScenarioElement written, Limits limits) {
    double mean = written.number("expectedValue");
    if (mean < 0 || mean > LARGEST_POISSON_MEAN) {
      parameters.wrong(
          "The expected value of a Poisson distribution is " + mean + ".",
          written.location("expectedValue"),
          "It is from 0 to " + (int) LARGEST_POISSON_MEAN + "; use a normal distribution beyond.");
      return Optional.empty();
    }
    return Optional.of(new Distribution.Poisson(mean, limits));
  }

  private Optional<Distribution> normal(ScenarioElement written, Limits limits) {
    double mean = written.number("expectedValue");
    double variance = written.number("variance");
    boolean logarithmic = written.name().equals("LogNormalDistribution");
    if (variance < 0 || (logarithmic && mean <= 0)) {
      parameters.wrong(
          "There are no numbers with the expected value "
              + mean
              + " and the variance "
              + variance
              + ".",
          written.location(),
          logarithmic ? "Both are greater than 0." : "A variance is not negative.");
      return Optional.empty();
    }
    return Optional.of(
        logarithmic
            ? new Distribution.LogNormal(mean, variance, limits)
            : new Distribution.Normal(mean, variance, limits));
  }
}
