package dev.eventchain.pipeline.campaign.plan;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Reads the values of factors. */
final class LevelsReader {

  /** Values of a range, as many as a campaign may have cases. */
  private static final int MOST = 1_000_000;

  private static final int MOST_DIGITS = 30;
  private static final BigDecimal LARGEST = BigDecimal.valueOf(1e12);
  private static final String BOUNDS = "Its bounds are two numbers, the smaller one first.";

  /** Stands for values that cannot be read. */
  private static final Levels NO_VALUES = new Levels.Listed(List.of(BigDecimal.ZERO));

  /** Of a normal distribution without bounds, 2 values in 10^9 are farther from its mean. */
  private static final BigDecimal DEVIATIONS = BigDecimal.valueOf(6);

  private LevelsReader() {}

  /** Reads them, of a factor of a campaign file; what is wrong is found there. */
  static Levels read(Path file, ObjectReader part) {
    List<String> kinds =
        List.of("values", "step", "uniform", "normal", "csv").stream().filter(part::has).toList();
    if (kinds.size() != 1) {
      part.find(
          Diagnostic.of(
                  kinds.isEmpty() ? CampaignRules.KEY_MISSING : CampaignRules.KEY_DUPLICATE,
                  "Its values are given by one of values, step, uniform, normal and csv.",
                  part.location())
              .withHint("For example `values: [10, 20]`, or `from: 10`, `to: 50`, `step: 5`."));
      kinds.forEach(part::value);
      return NO_VALUES;
    }
    return switch (kinds.get(0)) {
      case "values" -> new Levels.Listed(numbers(part, "values"));
      case "step" -> range(part);
      case "csv" -> new CsvColumn(file, part).read();
      case "normal" -> part.object("normal").map(LevelsReader::normal).orElse(NO_VALUES);
      default -> uniform(part);
    };
  }

  /** Returns whether a number is not too large for a scenario, and has not too many digits. */
  static boolean isUsual(BigDecimal number) {
    return Math.abs((double) number.scale()) <= MOST_DIGITS && number.abs().compareTo(LARGEST) <= 0;
  }

  private static List<BigDecimal> numbers(ObjectReader part, String key) {
    List<BigDecimal> numbers = new ArrayList<>();
    JsonNode array = part.value(key).orElseThrow();
    array.forEach(each -> numbers.add(each.isNumber() ? each.decimalValue() : BigDecimal.ZERO));
    boolean right = array.isArray() && !array.isEmpty();
    for (JsonNode each : array) {
      right &= each.isNumber() && isUsual(each.decimalValue());
    }
    if (!right) {
      part.find(CampaignRules.VALUE_TYPE, "'" + key + "' is a list of numbers.", part.at(key));
      return List.of(BigDecimal.ZERO);
    }
    if (numbers.stream().map(BigDecimal::stripTrailingZeros).distinct().count() < numbers.size()) {
      part.find(CampaignRules.VALUE_RANGE, "A value is there twice.", part.at(key));
    }
    return numbers;
  }

  private static Levels range(ObjectReader part) {
    BigDecimal from = decimal(part, "from");
    BigDecimal to = decimal(part, "to");
    BigDecimal step = decimal(part, "step");
    if (step.signum() <= 0 || to.compareTo(from) < 0) {
      String message = "A range goes from a number up to one that is not less, in steps above 0.";
      part.find(CampaignRules.VALUE_RANGE, message, part.at("step"));
      return new Levels.Listed(List.of(from));
    }
    BigDecimal steps = to.subtract(from).divideToIntegralValue(step);
    if (steps.compareTo(BigDecimal.valueOf(MOST)) > 0) {
      part.find(CampaignRules.SIZE, "These are more than a million values.", part.at("step"));
      return new Levels.Listed(List.of(from));
    }
    List<BigDecimal> values = new ArrayList<>();
    for (int i = 0; i <= steps.intValue(); i++) {
      values.add(from.add(step.multiply(BigDecimal.valueOf(i))));
    }
    return new Levels.Listed(values);
  }

  private static BigDecimal decimal(ObjectReader part, String key) {
    NumberRange any = NumberRange.of(-1e12, 1e12);
    return BigDecimal.valueOf(part.requiredNumber(key, any));
  }

  private static Levels uniform(ObjectReader part) {
    List<BigDecimal> bounds = numbers(part, "uniform");
    if (!areBounds(bounds)) {
      part.find(CampaignRules.VALUE_RANGE, BOUNDS, part.at("uniform"));
      return new Levels.Listed(bounds);
    }
    return new Levels.Uniform(bounds.get(0), bounds.get(1));
  }

  private static Levels normal(ObjectReader part) {
    BigDecimal mean = decimal(part, "mean");
    BigDecimal deviation =
        BigDecimal.valueOf(part.requiredNumber("deviation", NumberRange.of(1e-9, 1e12)));
    BigDecimal far = deviation.multiply(DEVIATIONS);
    List<BigDecimal> bounds =
        part.has("within") ? numbers(part, "within") : List.of(mean.subtract(far), mean.add(far));
    part.refuseOthers();
    if (!areBounds(bounds)) {
      part.find(CampaignRules.VALUE_RANGE, BOUNDS, part.at("within"));
      return NO_VALUES;
    }
    Levels.Normal normal = new Levels.Normal(mean, deviation, bounds.get(0), bounds.get(1));
    if (deviation.signum() > 0 && !normal.hasMass()) {
      String message = "Next to no value of the distribution lies within these bounds.";
      part.find(CampaignRules.VALUE_RANGE, message, part.at("within"));
    }
    return normal;
  }

  private static boolean areBounds(List<BigDecimal> numbers) {
    return numbers.size() == 2 && numbers.get(0).compareTo(numbers.get(1)) < 0;
  }
}
