package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.simulation.verdict.CaseResult;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Statements of a campaign file about a campaign.
 *
 * @param part its name in a file of several campaigns; empty in one of a single campaign
 * @param name that of its results
 * @param scenario the name of the scenario whose cases are simulated, or the path of its file
 * @param played the file in OpenSCENARIO XML that {@code scenario} names, if it is one
 * @param computed what follows from the factors, in the order of the file
 * @param conditions keep the combinations for which all are true
 * @param criteria what is required of cases, besides the criteria of the scenario
 * @param repetitions of each combination, with other seeds
 * @param seed of what is drawn
 * @param search what a search does with it
 * @param points how a protocol counts its cases; empty if none does
 */
public record CampaignPlan(
    Path file,
    Optional<String> part,
    String name,
    String scenario,
    Optional<PlayedScenario> played,
    List<Factor> factors,
    List<Computed> computed,
    Sampling sampling,
    List<SourceRange> conditions,
    List<CaseCriteria> criteria,
    int repetitions,
    long seed,
    Optional<Boundary> boundary,
    SearchSettings search,
    Optional<Points> points) {

  /**
   * A search for the values at which the verdict flips.
   *
   * @param factor the number of the factor along which it is searched
   * @param resolution the largest distance of two values with different verdicts
   * @param criterion the one whose outcome flips; without it, the verdict of the case does
   */
  public record Boundary(
      int factor, BigDecimal resolution, Optional<SearchSettings.Named> criterion) {}

  public CampaignPlan {
    factors = List.copyOf(factors);
    computed = List.copyOf(computed);
    conditions = List.copyOf(conditions);
    criteria = List.copyOf(criteria);
  }

  /** Returns the file of a scenario that is not one of the project's. */
  public Optional<Path> scenarioFile() {
    return scenario.matches(".*\\.ya?ml")
        ? Optional.of(file.resolveSibling(scenario))
        : Optional.empty();
  }

  /** Returns whether it has a list of cases: a grid has no end of values that have to be drawn. */
  public boolean isListed() {
    return sampling.kind().isDrawn()
        || factors.stream().noneMatch(factor -> factor.levels().isContinuous());
  }

  /** Returns the plan of a search: each combination once, and no grid. */
  public CampaignPlan ofSearch() {
    return new CampaignPlan(
        file,
        part,
        name,
        scenario,
        played,
        factors,
        computed,
        Sampling.USUAL,
        conditions,
        criteria,
        1,
        seed,
        Optional.empty(),
        search,
        Optional.empty());
  }

  public List<String> names() {
    return factors.stream().map(Factor::name).toList();
  }

  /** Returns the names of the factors, and of what is computed. */
  public List<String> allNames() {
    return Stream.concat(names().stream(), computed.stream().map(Computed::name)).toList();
  }

  /** Returns the tables that factors have their values from. */
  public List<Path> tables() {
    return tableNames().map(file::resolveSibling).toList();
  }

  /** Returns the names of the files that the campaign file names, as they are written there. */
  public List<String> named() {
    boolean isFile = played.isPresent() || scenarioFile().isPresent();
    return Stream.concat(Stream.of(scenario).filter(it -> isFile), tableNames()).toList();
  }

  private Stream<String> tableNames() {
    return factors.stream()
        .filter(factor -> factor.levels() instanceof Levels.Column)
        .map(factor -> ((Levels.Column) factor.levels()).table())
        .filter(table -> !isPlayed(table))
        .distinct();
  }

  private boolean isPlayed(String table) {
    return played.filter(it -> it.file().endsWith(table)).isPresent();
  }

  /** Returns the paths of all factors and of what is computed. */
  public Stream<String> paths() {
    return Stream.concat(
            factors.stream().map(Factor::paths), computed.stream().map(Computed::paths))
        .flatMap(List::stream);
  }

  /** Returns the values of the factors of a case, by their names. */
  Map<String, Double> numbers(CampaignCase each) {
    Map<String, Double> numbers = new LinkedHashMap<>();
    for (int i = 0; i < factors.size(); i++) {
      numbers.put(factors.get(i).name(), each.values().get(i).doubleValue());
    }
    return numbers;
  }

  /**
   * Returns the numbers of the scenario and the bench that a case sets, by their paths.
   *
   * @throws DiagnosticException (INPUT) if one that is computed has no value
   */
  public Map<String, BigDecimal> settings(CampaignCase each) {
    Map<String, BigDecimal> settings = new LinkedHashMap<>();
    for (int i = 0; i < factors.size(); i++) {
      BigDecimal value = each.values().get(i);
      factors.get(i).paths().forEach(path -> settings.put(path, value));
    }
    Map<String, Double> numbers = allNumbers(each);
    for (Computed next : computed) {
      BigDecimal number = BigDecimal.valueOf(numbers.get(next.name()));
      next.paths().forEach(path -> settings.put(path, number));
    }
    return settings;
  }

  /**
   * Returns the points of a case.
   *
   * @throws DiagnosticException (INPUT) if a formula has no value
   */
  public Optional<Points.Score> score(CampaignCase each, CaseResult result) {
    return points.map(it -> it.of(allNumbers(each), result));
  }

  /**
   * Returns whether points are counted for a case.
   *
   * @throws DiagnosticException (INPUT) if a formula has no value
   */
  public boolean counts(CampaignCase each) {
    return points.isPresent() && points.get().isCounted(allNumbers(each));
  }

  /**
   * Requires of what counts points that it has some for a case, whatever becomes of it.
   *
   * @throws DiagnosticException (INPUT) if it has none
   */
  public void requirePoints(CampaignCase each) {
    points.ifPresent(it -> it.require(allNumbers(each)));
  }

  /**
   * Returns the values of the factors of a case, and what is computed from them, by their names.
   *
   * @throws DiagnosticException (INPUT) if something has no value
   */
  public Map<String, Double> allNumbers(CampaignCase each) {
    Map<String, Double> numbers = numbers(each);
    for (Computed next : computed) {
      double value = next.formula().value().applyAsDouble(numbers);
      if (!Double.isFinite(value)) {
        String message = "'" + next.name() + "' is no number here, as after a division by 0.";
        throw new DiagnosticException(
            DiagnosticException.Reason.INPUT,
            Diagnostic.of(CampaignRules.FORMULA, message, next.place()));
      }
      numbers.put(next.name(), value);
    }
    return numbers;
  }
}
