package dev.eventchain.pipeline.evaluation;

import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;

/**
 * The result of one run of an evaluation.
 *
 * @param number from 1
 * @param reason the reason why it does not count, if it does not
 * @param chainModel the score of the chain and its valid model
 * @param functionCode the score of the components that the chain needs, which have to pass their
 *     checks
 * @param overall the score of all of that, with the verdict PASSED for the scenarios
 * @param implementedFor the chain that the components are for
 * @param authored true if people wrote any of the answers, so that it is not a measurement
 * @param answeredBy the models that answered, as their providers name them
 * @param usage the usage of the answers
 * @param failures the identifiers of the errors that the run failed by, as {@code stage: id}
 * @param tasks the results of its tasks
 * @param repairs the results of the repairs of its answers
 * @param host machine-dependent values
 */
record EvaluatedRun(
    String model,
    int number,
    State state,
    String reason,
    Score chainModel,
    Score functionCode,
    Score overall,
    String implementedFor,
    boolean authored,
    List<String> answeredBy,
    Usage usage,
    List<String> failures,
    List<TaskResult> tasks,
    List<RepairResult> repairs,
    Host host) {

  /** The states of a run: it counts, or the reason why not. */
  enum State {
    COUNTED("counted"),
    /** No recorded answer that earlier runs have not used. */
    UNRECORDED("no recorded answer"),
    /** The model could not be reached, which says nothing about its answers. */
    UNREACHABLE("not answered"),
    /** Waiting for an external answer. */
    WAITING("waiting for an answer"),
    /** The evaluation ended before. */
    NOT_BEGUN("not begun");

    private final String words;

    State(String words) {
      this.words = words;
    }

    /** Returns the text for people. */
    String words() {
      return words;
    }
  }

  /** The grades of an artefact. */
  enum Grade {
    PASSED,
    FAILED,
    /** Nothing to judge. */
    UNKNOWN
  }

  /**
   * The grades of an artefact.
   *
   * @param first the grade with the first answers only
   * @param last the grade with the answers after repair
   */
  record Score(Grade first, Grade last) {
    static final Score UNKNOWN = new Score(Grade.UNKNOWN, Grade.UNKNOWN);

    static Score of(boolean passed, boolean repaired) {
      return new Score(grade(passed && !repaired), grade(passed));
    }

    private static Grade grade(boolean passed) {
      return passed ? Grade.PASSED : Grade.FAILED;
    }
  }

  /**
   * The usage of answers.
   *
   * @param unknown the number of answers without a token count
   */
  record Usage(int calls, int unknown, long inputTokens, long outputTokens) {
    static final Usage NONE = new Usage(0, 0, 0, 0);

    Usage and(Usage other) {
      return new Usage(
          calls + other.calls,
          unknown + other.unknown,
          inputTokens + other.inputTokens,
          outputTokens + other.outputTokens);
    }
  }

  /**
   * Machine-dependent values.
   *
   * @param seconds the duration
   */
  record Host(double seconds) {}

  EvaluatedRun {
    Objects.requireNonNull(state);
    Objects.requireNonNull(chainModel);
    Objects.requireNonNull(functionCode);
    Objects.requireNonNull(overall);
    Objects.requireNonNull(usage);
    Objects.requireNonNull(host);
    answeredBy = List.copyOf(answeredBy);
    failures = List.copyOf(failures);
    tasks = List.copyOf(tasks);
    repairs = List.copyOf(repairs);
  }

  /** Returns a run that does not count. */
  static EvaluatedRun uncounted(String model, int number, State state, String reason) {
    return new EvaluatedRun(
        model,
        number,
        state,
        reason,
        Score.UNKNOWN,
        Score.UNKNOWN,
        Score.UNKNOWN,
        "",
        false,
        List.of(),
        Usage.NONE,
        List.of(),
        List.of(),
        List.of(),
        new Host(0));
  }

  /** Returns a copy with additional failures. */
  EvaluatedRun withFailures(List<String> more) {
    Set<String> all = new TreeSet<>(failures);
    all.addAll(more);
    return new EvaluatedRun(
        model,
        number,
        state,
        reason,
        chainModel,
        functionCode,
        overall,
        implementedFor,
        authored,
        answeredBy,
        usage,
        List.copyOf(all),
        tasks,
        repairs,
        host);
  }

  boolean isCounted() {
    return state == State.COUNTED;
  }
}
