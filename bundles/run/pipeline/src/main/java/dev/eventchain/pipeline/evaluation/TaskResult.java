package dev.eventchain.pipeline.evaluation;

import dev.eventchain.pipeline.evaluation.EvaluatedRun.Usage;
import dev.eventchain.pipeline.stage.Sample;
import java.util.LinkedHashMap;
import java.util.List;

/**
 * Counts of how often a language model did a task.
 *
 * @param task as in configurations; {@code verdict} for a correction after a failed verdict
 * @param asked number of its questions, each with the repairs that follow it
 * @param first number of these whose first answer was accepted
 * @param accepted number of these of which an answer was accepted
 * @param bytes of all its answers, in UTF-8
 */
record TaskResult(String task, int asked, int first, int accepted, long bytes, Usage usage) {

  /** Returns the results of tasks, in the order in which they were first asked. */
  static List<TaskResult> of(List<Sample.Answer> answers) {
    return EvaluationRow.sums(
        answers.stream().map(TaskResult::of),
        TaskResult::task,
        TaskResult::and,
        new LinkedHashMap<>());
  }

  private static TaskResult of(Sample.Answer answer) {
    boolean begins = answer.attempt() == 1;
    return new TaskResult(
        answer.task(),
        begins ? 1 : 0,
        begins && answer.accepted() ? 1 : 0,
        answer.accepted() ? 1 : 0,
        answer.bytes(),
        answer
            .usage()
            .map(it -> new Usage(1, 0, it.inputTokens(), it.outputTokens()))
            .orElse(new Usage(1, 1, 0, 0)));
  }

  /** Returns the sum of this and another result of the task. */
  TaskResult and(TaskResult other) {
    return new TaskResult(
        task,
        asked + other.asked,
        first + other.first,
        accepted + other.accepted,
        bytes + other.bytes,
        usage.and(other.usage));
  }
}
