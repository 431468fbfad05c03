package dev.eventchain.pipeline.evaluation;

import dev.eventchain.agents.AgentRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.llm.chat.AnswerTrait;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.engine.PipelineRun;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Grade;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Host;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Score;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.State;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Usage;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.Progress.Status;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.RunResult.Verdict;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.Sample;
import dev.eventchain.pipeline.stage.StageOutcome;
import dev.eventchain.project.ProjectFolder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/** Executes one run of an evaluation and judges its result. */
final class EvaluationRun {

  private static final String IMPLEMENT = Stage.IMPLEMENT.id();

  /** Tasks of the code: a component passes only with tests that the model wrote. */
  private static final Set<String> CODE = Set.of("test", IMPLEMENT);

  /** Rule of a finding that only introduces the following ones. */
  private static final Rule REJECTED = AgentRules.ANSWER_REJECTED;

  private static final String AUTHORED = "authored";

  private final Task task;
  private final Progress progress;
  private Sample sample;

  /**
   * The task of a run.
   *
   * @param options of the runs of stages, with the folder of this run
   * @param reference the chain whose components are written where none has been designed
   * @param session the recorded session that answers, if one does
   */
  record Task(
      Project project,
      RunOptions options,
      String model,
      int number,
      Optional<ReferenceChain> reference,
      Optional<AnswerSession> session) {}

  /**
   * The result of a task.
   *
   * @param findings the findings that explain why it does not count, if it does not
   */
  record Done(EvaluatedRun run, List<Diagnostic> findings) {}

  EvaluationRun(Task task, Sample sample, Progress progress) {
    this.task = task;
    this.sample = sample;
    this.progress = progress;
  }

  /**
   * Executes the run.
   *
   * @throws DiagnosticException if the project or this machine is the cause, and not the model
   */
  Done perform() {
    long start = System.nanoTime();
    if (task.session().isPresent()) {
      return ofSession(task.session().get(), start);
    }
    PipelineRun.Ended ended = run(task.options(), sample);
    Optional<Done> stopped = stopped(ended, sample, task.options().output());
    if (stopped.isPresent()) {
      return stopped.get();
    }
    if (isDone(ended, Stage.DESIGN)) {
      Score code = functionCode(ended, sample);
      return judged(ended, code, "the run's own chain", Optional.empty(), start);
    }
    if (task.reference().isEmpty()) {
      return judged(ended, Score.UNKNOWN, "", Optional.empty(), start);
    }
    return onReference(ended, task.reference().get(), start);
  }

  /** Judges a run that a recorded session answers, and that may end with it. */
  private Done ofSession(AnswerSession session, long start) {
    PipelineRun.Ended ended = session.run(this::round);
    boolean waiting = !awaited(ended).isEmpty();
    Optional<Done> stopped =
        waiting ? Optional.empty() : stopped(ended, sample, task.options().output());
    Done done =
        stopped.orElseGet(
            () ->
                judged(
                    ended,
                    functionCode(ended, sample),
                    "the run's own chain",
                    Optional.empty(),
                    start));
    List<Diagnostic> found = new ArrayList<>(done.findings());
    found.addAll(session.findings(waiting));
    return new Done(done.run(), found);
  }

  /** Runs all stages anew: what was answered in earlier rounds is recorded. */
  private PipelineRun.Ended round() {
    sample = sample.again();
    return run(task.options(), sample);
  }

  private PipelineRun.Ended run(RunOptions options, Sample asked) {
    Project project = task.project().evaluating(asked.model());
    return PipelineRun.run(project, options, progress, Optional.of(asked));
  }

  /** Returns the components of a chain that this run did not design. */
  private Done onReference(PipelineRun.Ended ended, ReferenceChain reference, long start) {
    Path folder = task.options().output().resolve("reference");
    try (OutputFolder output = OutputFolder.open(folder)) {
      byte[] description = reference.description().getBytes(StandardCharsets.UTF_8);
      output.write(ProjectFolder.DESCRIPTION, description, OutputFolder.OnEdit.OVERWRITE);
    }
    Sample second = sample.again();
    PipelineRun.Ended implemented =
        run(task.options().in(folder, Stage.IMPLEMENT, Stage.IMPLEMENT), second);
    Optional<Done> stopped = stopped(implemented, second, folder);
    boolean unrecorded =
        stopped.map(Done::run).map(EvaluatedRun::state).stream().anyMatch(State.UNRECORDED::equals);
    if (stopped.isPresent() && !unrecorded) {
      return stopped.get();
    }
    if (unrecorded) {
      return judged(ended, Score.UNKNOWN, "", Optional.of(second), start);
    }
    Done done =
        judged(
            ended, functionCode(implemented, second), reference.name(), Optional.of(second), start);
    return new Done(done.run().withFailures(failures(implemented)), List.of());
  }

  /**
   * Returns the result of a run that does not count because its end was not caused by the model's
   * answers.
   */
  private Optional<Done> stopped(PipelineRun.Ended ended, Sample asked, Path folder) {
    Optional<Reason> failure = ended.result().failure();
    List<Diagnostic> last = lastFailure(ended);
    List<Diagnostic> unasked = unasked(ended);
    if (unasked.stream().anyMatch(each -> each.kind().has(AnswerTrait.UNRECORDED))) {
      return Optional.of(uncounted(State.UNRECORDED, State.UNRECORDED.words(), List.of()));
    }
    if (failure.equals(Optional.of(Reason.UNAVAILABLE)) && !unasked.isEmpty()) {
      return Optional.of(uncounted(State.UNREACHABLE, unasked.get(0).message(), unasked));
    }
    if (failure.equals(Optional.of(Reason.UNAVAILABLE)) || !unasked.isEmpty()) {
      throw new DiagnosticException(
          failure.orElse(Reason.INPUT), unasked.isEmpty() ? last : unasked);
    }
    if (failure.equals(Optional.of(Reason.INPUT))) {
      requireFault(Reason.INPUT, asked, last, isBelow(folder, last));
    }
    List<Diagnostic> awaited = awaited(ended);
    if (!awaited.isEmpty()) {
      return Optional.of(uncounted(State.WAITING, State.WAITING.words(), awaited));
    }
    if (failure.isPresent()) {
      requireFault(failure.get(), asked, last, true);
    }
    return Optional.empty();
  }

  /**
   * Throws unless the model caused the failure: it has answered, and the findings concern its
   * files.
   */
  private static void requireFault(
      Reason reason, Sample asked, List<Diagnostic> found, boolean own) {
    if (asked.calls().isEmpty() || !own) {
      throw new DiagnosticException(reason, found);
    }
  }

  private static boolean isBelow(Path folder, List<Diagnostic> found) {
    String base = SourceLocation.of(folder).file() + "/";
    return found.stream().allMatch(each -> each.location().file().startsWith(base));
  }

  private Done uncounted(State state, String reason, List<Diagnostic> found) {
    String line = reason.lines().findFirst().orElse("");
    return new Done(EvaluatedRun.uncounted(task.model(), task.number(), state, line), found);
  }

  private static List<Diagnostic> lastFailure(PipelineRun.Ended ended) {
    return ended.outcomes().values().stream()
        .filter(outcome -> outcome.status() == Status.FAILED)
        .map(StageOutcome::diagnostics)
        .reduce((earlier, later) -> later)
        .orElse(List.of());
  }

  /**
   * Returns the errors because of which answers are missing, in any stage, including those after
   * repair.
   */
  private static List<Diagnostic> unasked(PipelineRun.Ended ended) {
    return ended.outcomes().values().stream()
        .filter(outcome -> outcome.status() == Status.FAILED)
        .flatMap(outcome -> outcome.diagnostics().stream())
        .filter(
            each -> each.severity() == Severity.ERROR && each.kind().has(AnswerTrait.UNANSWERED))
        .toList();
  }

  private static List<Diagnostic> awaited(PipelineRun.Ended ended) {
    return ended.outcomes().values().stream()
        .filter(outcome -> outcome.status() == Status.WAITING)
        .flatMap(outcome -> outcome.diagnostics().stream())
        .toList();
  }

  private static boolean isDone(PipelineRun.Ended ended, Stage stage) {
    return ended.outcomes().get(stage).status() == Status.DONE;
  }

  /**
   * Returns the score of the code; unknown if no component was missing, so that none was written.
   */
  private static Score functionCode(PipelineRun.Ended ended, Sample asked) {
    boolean written = asked.calls().stream().anyMatch(call -> CODE.contains(call.task()));
    return written
        ? Score.of(isWritten(ended, asked), isRepaired(asked.calls(), Set.of(IMPLEMENT)))
        : Score.UNKNOWN;
  }

  /** Returns whether all components passed their tests, also where a correction is waited for. */
  private static boolean isWritten(PipelineRun.Ended ended, Sample asked) {
    boolean simulated =
        ended.outcomes().get(Stage.SIMULATE).report().isPresent()
            || asked.answers().stream().anyMatch(it -> it.task().equals(Sample.DIAGNOSE));
    return isDone(ended, Stage.IMPLEMENT) || (simulated && !awaited(ended).isEmpty());
  }

  private static boolean isRepaired(List<Sample.Call> calls, Collection<String> tasks) {
    return calls.stream().anyMatch(call -> call.repair() && tasks.contains(call.task()));
  }

  private Done judged(
      PipelineRun.Ended ended, Score code, String chain, Optional<Sample> more, long start) {
    List<Sample> asked = Stream.concat(Stream.of(sample), more.stream()).toList();
    List<Sample.Call> calls = asked.stream().flatMap(it -> it.calls().stream()).toList();
    List<Sample.Answer> answers = asked.stream().flatMap(it -> it.answers().stream()).toList();
    Set<String> modeling = Set.of("design", "model", "constrain");
    boolean valid =
        Stream.of(Stage.DESIGN, Stage.MODEL, Stage.CONSTRAIN, Stage.VALIDATE)
            .allMatch(stage -> isDone(ended, stage));
    boolean passed =
        valid && isDone(ended, Stage.IMPLEMENT) && ended.result().verdict() == Verdict.PASSED;
    boolean repaired = calls.stream().anyMatch(Sample.Call::repair);
    return new Done(
        new EvaluatedRun(
            task.model(),
            task.number(),
            State.COUNTED,
            "",
            Score.of(valid, isRepaired(calls, modeling)),
            code,
            Score.of(passed, repaired),
            code.last() == Grade.UNKNOWN ? "" : chain,
            calls.stream().anyMatch(call -> call.response().provenance().equals(AUTHORED)),
            calls.stream().map(call -> call.response().model()).distinct().sorted().toList(),
            usage(calls),
            failures(ended),
            TaskResult.of(answers),
            RepairResult.of(answers),
            new Host((System.nanoTime() - start) / 1e9)),
        List.of());
  }

  private static Usage usage(List<Sample.Call> calls) {
    Usage sum = Usage.NONE;
    for (Sample.Call call : calls) {
      sum =
          sum.and(
              call.response()
                  .usage()
                  .map(each -> new Usage(1, 0, each.inputTokens(), each.outputTokens()))
                  .orElse(new Usage(1, 1, 0, 0)));
    }
    return sum;
  }

  /** Returns the errors that failed stages or, if none failed, prevent the verdict PASSED. */
  private static List<String> failures(PipelineRun.Ended ended) {
    Set<String> classes = new TreeSet<>();
    for (Map.Entry<Stage, StageOutcome> each : ended.outcomes().entrySet()) {
      if (each.getValue().status() == Status.FAILED) {
        classes.addAll(classes(each.getKey().id(), each.getValue().diagnostics()));
      }
    }
    if (classes.isEmpty() && ended.result().verdict() != Verdict.PASSED) {
      classes.addAll(classes(Stage.REPORT.id(), ended.result().diagnostics()));
    }
    return List.copyOf(classes);
  }

  private static List<String> classes(String stage, List<Diagnostic> found) {
    List<String> ids =
        found.stream()
            .filter(finding -> finding.severity() == Severity.ERROR)
            .map(Diagnostic::id)
            .distinct()
            .toList();
    return ids.stream()
        .filter(id -> !id.equals(REJECTED.id()) || ids.size() == 1)
        .map(id -> stage + ": " + id)
        .toList();
  }
}
