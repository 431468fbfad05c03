package dev.eventchain.pipeline.evaluation;

import dev.eventchain.pipeline.stage.Sample;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Counts of how often an error in an answer was mended in the next one.
 *
 * @param error as {@code task: id}
 * @param sentBack number of answers with it that were sent back and answered again
 * @param right number of these of which the next answer was accepted, or was without it and had no
 *     other error that the first one did not have
 */
record RepairResult(String error, int sentBack, int right) {

  /** Returns the results of the repairs among answers, by error. */
  static List<RepairResult> of(List<Sample.Answer> answers) {
    Map<String, RepairResult> repairs = new TreeMap<>();
    for (int i = 0; i < answers.size(); i++) {
      Sample.Answer refused = answers.get(i);
      answers.subList(i + 1, answers.size()).stream()
          .filter(refused::isAbout)
          .findFirst()
          .filter(next -> next.attempt() == refused.attempt() + 1)
          .ifPresent(
              next ->
                  refused.errors().stream()
                      .map(id -> of(refused, id, next))
                      .forEach(it -> repairs.merge(it.error(), it, RepairResult::and)));
    }
    return new ArrayList<>(repairs.values());
  }

  private static RepairResult of(Sample.Answer refused, String id, Sample.Answer next) {
    // An error that is new may hide those that were there: code that does not parse fails no test.
    boolean anyNew = !refused.errors().containsAll(next.errors());
    boolean isRight = next.accepted() || (!anyNew && !next.errors().contains(id));
    return new RepairResult(refused.task() + ": " + id, 1, isRight ? 1 : 0);
  }

  /** Returns the sum of this and another result of the error. */
  RepairResult and(RepairResult other) {
    return new RepairResult(error, sentBack + other.sentBack, right + other.right);
  }
}
