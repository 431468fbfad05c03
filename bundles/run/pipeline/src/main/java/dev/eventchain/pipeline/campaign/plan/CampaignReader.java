package dev.eventchain.pipeline.campaign.plan;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.scenario.NumberFormulas;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;

/** Reads campaign files. */
public final class CampaignReader {

  private static final NumberRange CASES = NumberRange.of(1, 1_000_000);
  private static final NumberRange SEED = NumberRange.of(0, 1L << 52);
  private static final NumberRange REPETITIONS = NumberRange.of(1, 1000);

  private static final int MOST_DIGITS = 30;
  private static final BigDecimal LARGEST = BigDecimal.valueOf(1e12);
  private static final String BOUNDS = "Its bounds are two numbers, the smaller one first.";

  /** Stands for values that cannot be read. */
  private static final Levels NO_VALUES = new Levels.Listed(List.of(BigDecimal.ZERO));

  /** Of a normal distribution without bounds, 2 values in 10^9 are farther from its mean. */
  private static final BigDecimal DEVIATIONS = BigDecimal.valueOf(6);

  private final Path file;
  private final boolean isSearched;
  private final SourceText text;

  private CampaignReader(Path file, boolean isSearched) {
    this.file = file;
    this.isSearched = isSearched;
    this.text = SourceText.read(file);
  }

  /**
   * Reads a campaign file.
   *
   * @throws DiagnosticException (INPUT) with every problem of the file
   */
  public static CampaignPlan read(Path file) {
    return new CampaignReader(file, false).read();
  }

  /**
   * Reads a campaign file for a search, which goes between the bounds of factors by itself.
   *
   * @throws DiagnosticException (INPUT) with every problem of the file
   */
  public static CampaignPlan readForSearch(Path file) {
    return new CampaignReader(file, true).read();
  }

  private CampaignPlan read() {
    List<Diagnostic> problems = new ArrayList<>();
    Document document =
        Document.parse(text, DocumentFormat.YAML, CampaignRules.OF_DOCUMENTS, problems::add);
    Optional<CampaignPlan> plan = document.object("", problems::add).map(this::plan);
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return plan.orElseThrow();
  }

  private CampaignPlan plan(ObjectReader section) {
    String scenario = section.requiredText("scenario");
    section.text("description"); // for people
    List<Factor> factors = section.requiredObject("factors").map(this::factors).orElse(List.of());
    Sampling sampling = section.object("sampling").map(this::sampling).orElse(Sampling.USUAL);
    requireFit(section, factors, sampling);
    List<Computed> computed = computedOf(section, factors);
    List<SourceRange> conditions = conditions(section);
    int repetitions = (int) section.wholeNumber("repetitions", REPETITIONS).orElse(1);
    long seed = section.wholeNumber("seed", SEED).orElse(1);
    Optional<CampaignPlan.Boundary> boundary =
        section.object("boundary").flatMap(part -> boundary(part, factors, sampling));
    SearchSettings search =
        section.object("search").map(SearchSettings::read).orElse(SearchSettings.USUAL);
    section.refuseOthers();
    String name = file.getFileName().toString().replaceFirst("\\.ya?ml$", "");
    return new CampaignPlan(
        file,
        name,
        scenario,
        factors,
        computed,
        sampling,
        conditions,
        repetitions,
        seed,
        boundary,
        search);
  }

  /** Requires of the factors that their values can be combined as asked for. */
  private void requireFit(ObjectReader section, List<Factor> factors, Sampling sampling) {
    if (!sampling.kind().isDrawn() && !isSearched) {
      factors.stream()
          .filter(factor -> factor.levels().isContinuous())
          .forEach(factor -> section.find(undrawn(factor)));
    }
    if (sampling.kind() == Sampling.Kind.ROWS && tables(factors) != 1) {
      String message = "Rows need factors that are all columns of one table.";
      section.find(CampaignRules.VALUE_RANGE, message, section.at("sampling"));
    }
  }

  private List<Computed> computedOf(ObjectReader section, List<Factor> factors) {
    Optional<ObjectReader> formulas = section.object("computed");
    List<Computed> computed = formulas.map(it -> computed(it, factors)).orElse(List.of());
    if (computed.size() == formulas.map(it -> it.names().size()).orElse(0)) {
      requireUse(section, factors, computed);
    } // else nobody knows what the formulas read that cannot be read
    return computed;
  }

  /** Returns how many tables the factors are from; 0 if one is from none. */
  private static long tables(List<Factor> factors) {
    return factors.stream().allMatch(factor -> factor.levels() instanceof Levels.Column)
        ? factors.stream().map(it -> ((Levels.Column) it.levels()).table()).distinct().count()
        : 0;
  }

  private List<Computed> computed(ObjectReader section, List<Factor> factors) {
    List<String> known = new ArrayList<>(factors.stream().map(Factor::name).toList());
    List<Computed> computed = new ArrayList<>();
    for (String name : section.names()) {
      requireName(section, name);
      if (known.contains(name)) {
        String message = "There is a factor '" + name + "' already.";
        section.find(CampaignRules.KEY_DUPLICATE, message, section.atKey(name));
      }
      section
          .object(name)
          .flatMap(part -> computed(name, part, new NumberFormulas(known)))
          .ifPresent(computed::add);
      known.add(name);
    }
    return computed;
  }

  private Optional<Computed> computed(String name, ObjectReader part, NumberFormulas formulas) {
    List<String> paths = paths(part);
    String formula = part.requiredText("formula");
    part.refuseOthers();
    if (formula.isEmpty()) {
      return Optional.empty();
    }
    try {
      SourceRange range = SourceText.within(part.at("formula"), formula).whole();
      return Optional.of(new Computed(name, paths, formulas.quantity(range), part.location()));
    } catch (DiagnosticException e) {
      Diagnostic first = e.diagnostics().get(0);
      part.find(
          Diagnostic.of(CampaignRules.FORMULA, first.message(), part.at("formula"))
              .withHint(first.hint()));
      return Optional.empty();
    }
  }

  /** Requires of each factor and of what is computed that the scenario or a formula reads it. */
  private static void requireUse(
      ObjectReader section, List<Factor> factors, List<Computed> computed) {
    Set<String> read = new HashSet<>();
    computed.forEach(each -> read.addAll(each.formula().names()));
    Map<String, SourceLocation> idle = new LinkedHashMap<>();
    factors.stream()
        .filter(each -> each.paths().isEmpty())
        .forEach(each -> idle.put(each.name(), each.place()));
    computed.stream()
        .filter(each -> each.paths().isEmpty())
        .forEach(each -> idle.put(each.name(), each.place()));
    idle.keySet().removeAll(read);
    idle.values()
        .forEach(
            place ->
                section.find(
                    Diagnostic.of(CampaignRules.KEY_MISSING, "'path' is missing.", place)
                        .withHint(
                            "Write the number of the scenario that it is, such as ego.speed_kmh, or"
                                + " read it in a formula under `computed`.")));
  }

  private static Diagnostic undrawn(Factor factor) {
    return Diagnostic.of(
            CampaignRules.SIZE,
            "The values of '"
                + factor.name()
                + "' have to be drawn, and a grid has no end of them.",
            factor.place())
        .withHint("Write, for example, `sampling: {latin_hypercube: 200}`, or values or steps.");
  }

  private List<SourceRange> conditions(ObjectReader section) {
    List<SourceRange> conditions = new ArrayList<>();
    List<String> texts = section.texts("where");
    for (int i = 0; i < texts.size(); i++) {
      conditions.add(SourceText.within(section.at("where"), texts.get(i)).whole());
    }
    return conditions;
  }

  private List<Factor> factors(ObjectReader section) {
    List<Factor> factors = new ArrayList<>();
    for (String name : section.names()) {
      requireName(section, name);
      section.object(name).ifPresent(part -> factors.add(factor(name, part)));
    }
    if (factors.isEmpty()) {
      section.find(CampaignRules.EMPTY, "There is no factor.", section.location());
    }
    return factors;
  }

  private static void requireName(ObjectReader section, String name) {
    if (!name.matches("[A-Za-z_][A-Za-z0-9_]*")) {
      String message = "A factor has a name of letters, digits and underscores.";
      section.find(CampaignRules.VALUE_RANGE, message, section.atKey(name));
    }
  }

  private static List<String> paths(ObjectReader part) {
    List<String> paths = new ArrayList<>(part.texts("paths"));
    part.text("path").ifPresent(paths::add);
    return paths;
  }

  private Factor factor(String name, ObjectReader part) {
    List<String> paths = paths(part);
    Levels levels = levels(part);
    part.refuseOthers();
    return new Factor(name, paths, levels, part.location());
  }

  private Levels levels(ObjectReader part) {
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
      case "normal" -> part.object("normal").map(CampaignReader::normal).orElse(NO_VALUES);
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
    if (steps.compareTo(BigDecimal.valueOf((long) CASES.most())) > 0) {
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

  private Sampling sampling(ObjectReader part) {
    List<Sampling.Kind> kinds =
        Arrays.stream(Sampling.Kind.values()).filter(kind -> part.has(kind.key())).toList();
    Sampling.Kind kind = kinds.isEmpty() ? Sampling.Kind.GRID : kinds.get(0);
    if (kinds.size() != 1) {
      String known = "One of grid, rows, pairs, random, latin_hypercube and halton is needed.";
      part.find(CampaignRules.VALUE_RANGE, known, part.location());
      kinds.forEach(each -> part.value(each.key()));
    } else if (!kind.isDrawn()) {
      part.requireTrue(kind.key());
    }
    int cases = kind.isDrawn() ? (int) part.requiredWholeNumber(kind.key(), CASES) : 0;
    part.refuseOthers();
    return new Sampling(kind, cases);
  }

  private static Optional<CampaignPlan.Boundary> boundary(
      ObjectReader part, List<Factor> factors, Sampling sampling) {
    String name = part.requiredText("factor");
    double resolution = part.requiredNumber("resolution", NumberRange.of(1e-9, 1e12));
    part.refuseOthers();
    List<String> names = factors.stream().map(Factor::name).toList();
    OptionalInt index =
        OptionalInt.of(names.indexOf(name)).stream().filter(it -> it >= 0).findFirst();
    if (index.isEmpty()) {
      part.find(
          Diagnostic.of(
                  CampaignRules.FACTOR, "There is no factor '" + name + "'.", part.at("factor"))
              .withHint(NearestName.hint(name, names)));
      return Optional.empty();
    }
    if (sampling.kind() != Sampling.Kind.GRID) {
      String message = "A boundary is searched from a grid on.";
      part.find(CampaignRules.VALUE_RANGE, message, part.location());
    }
    return Optional.of(new CampaignPlan.Boundary(index.getAsInt(), BigDecimal.valueOf(resolution)));
  }
}
