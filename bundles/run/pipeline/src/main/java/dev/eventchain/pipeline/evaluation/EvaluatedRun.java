package dev.eventchain.pipeline.evaluation;

import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;

/**
 * What one run of an evaluation came to.
 *
 * @param number from 1
 * @param reason why it does not count, if it does not
 * @param chainModel whether there is a chain and a model of it that is valid
 * @param functionCode whether there are the components that the chain needs, which pass their
 *     checks
 * @param overall whether all of that holds, and the verdict of the scenarios is PASSED
 * @param implementedFor the chain that the components are for
 * @param authored whether people wrote any of the answers, so that it is not a measurement
 * @param answeredBy the models that answered, as their providers name them
 * @param usage what the answers cost
 * @param failures what the run failed by, as {@code stage: id}
 * @param returned what was wrong with answers that a model could fix
 * @param host what depends on this machine
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
    List<String> returned,
    Host host) {

  /** Whether a run counts, and why not. */
  enum State {
    COUNTED("counted"),
    /** No answer is recorded that an earlier run has not taken. */
    UNRECORDED("no recorded answer"),
    /** The model could not be asked, which says nothing about its answers. */
    UNREACHABLE("not answered"),
    /** An answer from outside is awaited. */
    WAITING("waiting for an answer"),
    /** The evaluation ended before. */
    NOT_BEGUN("not begun");

    private final String words;

    State(String words) {
      this.words = words;
    }

    /** The words that people read. */
    String words() {
      return words;
    }
  }

  /** What an artefact came to. */
  enum Grade {
    PASSED,
    FAILED,
    /** There was nothing to judge. */
    UNKNOWN
  }

  /**
   * What an artefact came to.
   *
   * @param first with the first answers only
   * @param last with the answers after repair
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
   * What answers cost.
   *
   * @param unknown how many of them came without a number of tokens
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
   * What depends on this machine.
   *
   * @param seconds how long it took
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
    returned = List.copyOf(returned);
  }

  /** Of a run that does not count. */
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
        new Host(0));
  }

  /** The same with more that it failed by. */
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
        returned,
        host);
  }

  boolean isCounted() {
    return state == State.COUNTED;
  }
}
