package dev.eventchain.pipeline.evaluation;

import dev.eventchain.pipeline.evaluation.EvaluatedRun.Grade;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Score;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.State;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Usage;
import dev.eventchain.pipeline.project.Configuration;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.BinaryOperator;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * A row of the table: the runs of a model. Runs with answers that people wrote are never counted
 * together with others.
 *
 * @param authored true if people wrote answers of its runs, so that it measures no language model
 * @param counted the runs that count
 * @param uncounted those that do not
 */
record EvaluationRow(
    String model, boolean authored, List<EvaluatedRun> counted, List<EvaluatedRun> uncounted) {

  /** Judged artefacts by their names in files. */
  static final Map<String, Function<EvaluatedRun, Score>> ARTEFACTS = artefacts();

  /**
   * The number of runs that passed, of those with something to judge.
   *
   * @param of the number of runs with something to judge
   */
  record Rate(int passed, int of) {
    Optional<WilsonInterval> interval() {
      return WilsonInterval.of(passed, of);
    }
  }

  private static Map<String, Function<EvaluatedRun, Score>> artefacts() {
    Map<String, Function<EvaluatedRun, Score>> artefacts = new LinkedHashMap<>();
    artefacts.put("chainModel", EvaluatedRun::chainModel);
    artefacts.put("functionCode", EvaluatedRun::functionCode);
    artefacts.put("overall", EvaluatedRun::overall);
    return artefacts;
  }

  /** Returns the rows of a model: one, or two if people wrote answers of some of its runs. */
  static List<EvaluationRow> of(String model, List<EvaluatedRun> runs) {
    List<EvaluatedRun> uncounted = runs.stream().filter(run -> !run.isCounted()).toList();
    List<EvaluationRow> rows = new ArrayList<>();
    for (boolean authored : new boolean[] {false, true}) {
      List<EvaluatedRun> counted =
          runs.stream().filter(run -> run.isCounted() && run.authored() == authored).toList();
      if (!counted.isEmpty()) {
        rows.add(
            new EvaluationRow(model, authored, counted, rows.isEmpty() ? uncounted : List.of()));
      }
    }
    return rows.isEmpty() ? List.of(new EvaluationRow(model, false, List.of(), uncounted)) : rows;
  }

  /**
   * Returns the pass rate of an artefact, with the first answers only or with those after repair.
   */
  Rate rate(Function<EvaluatedRun, Score> artefact, boolean repaired) {
    List<Grade> grades =
        counted.stream()
            .map(artefact)
            .map(score -> repaired ? score.last() : score.first())
            .filter(grade -> grade != Grade.UNKNOWN)
            .toList();
    return new Rate((int) grades.stream().filter(Grade.PASSED::equals).count(), grades.size());
  }

  /** Returns the runs that do not count, by reason. */
  Map<State, Integer> reasons() {
    Map<State, Integer> reasons = new EnumMap<>(State.class);
    uncounted.forEach(run -> reasons.merge(run.state(), 1, Integer::sum));
    return reasons;
  }

  /** Returns the number of runs per class, most frequent first. */
  Map<String, Integer> classes(Function<EvaluatedRun, List<String>> each) {
    SortedMap<String, Integer> counts = new TreeMap<>();
    counted.forEach(run -> each.apply(run).forEach(name -> counts.merge(name, 1, Integer::sum)));
    Map<String, Integer> sorted = new LinkedHashMap<>();
    counts.entrySet().stream()
        .sorted((one, other) -> other.getValue() - one.getValue())
        .forEach(entry -> sorted.put(entry.getKey(), entry.getValue()));
    return sorted;
  }

  /** Returns the results of each task, in the order in which the first run did them. */
  List<TaskResult> tasks() {
    Stream<TaskResult> all = counted.stream().flatMap(run -> run.tasks().stream());
    return sums(all, TaskResult::task, TaskResult::and, new LinkedHashMap<>());
  }

  /** Returns the results of the repairs, by error. */
  List<RepairResult> repairs() {
    Stream<RepairResult> all = counted.stream().flatMap(run -> run.repairs().stream());
    return sums(all, RepairResult::error, RepairResult::and, new TreeMap<>());
  }

  /** Returns the sums of what has one name, in the order of a map. */
  static <T> List<T> sums(
      Stream<T> all, Function<T, String> name, BinaryOperator<T> sum, Map<String, T> into) {
    all.forEach(each -> into.merge(name.apply(each), each, sum));
    return List.copyOf(into.values());
  }

  Usage usage() {
    return counted.stream().map(EvaluatedRun::usage).reduce(Usage.NONE, Usage::and);
  }

  /** Returns the cost of the answers; empty if a price or a token count is unknown. */
  Optional<BigDecimal> cost(Configuration configuration) {
    Usage usage = usage();
    return usage.unknown() > 0 || usage.calls() == 0
        ? Optional.empty()
        : configuration.services().cost(model, usage.inputTokens(), usage.outputTokens());
  }

  double seconds() {
    return counted.stream().mapToDouble(run -> run.host().seconds()).sum();
  }
}
