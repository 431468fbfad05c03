package dev.eventchain.pipeline.evaluation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.llm.Spending;
import dev.eventchain.llm.chat.AnswerTrait;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.State;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.project.StrengthExtent;
import dev.eventchain.pipeline.run.Answers;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.SimulationOptions;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.run.Stages;
import dev.eventchain.pipeline.stage.Sample;
import dev.eventchain.project.ProjectLayout;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;

/**
 * Compares language models: each does all tasks of several runs of a project; counts the results as
 * in the paper's table.
 */
public final class LanguageModelEvaluation {

  private static final String HANDOFF = "handoff:";

  /** A listener for the progress of an evaluation, called on any thread. */
  public interface Listener {
    /** Reports a step of a run. */
    void step(String model, int run, String message);

    /**
     * Reports the end of a run.
     *
     * @param counted true if it counts
     * @param words a short description of the result
     */
    void ended(String model, int run, boolean counted, Duration duration, String words);
  }

  private final Project project;
  private final EvaluationOptions options;
  private final Listener listener;
  private final EvaluationFolder folder;
  private final Optional<ReferenceChain> reference;
  private final Spending spending;
  private final Set<String> unreachable = ConcurrentHashMap.newKeySet();
  private volatile boolean ended;

  private LanguageModelEvaluation(
      Project project, EvaluationOptions options, Listener listener, EvaluationFolder folder) {
    this.project = project;
    this.options = options;
    this.listener = listener;
    this.folder = folder;
    this.reference = ReferenceChain.of(project, options.output());
    this.spending = new Spending(project.configuration().services());
  }

  /**
   * Evaluates language models. Reuses finished runs with the same inputs; continues unfinished runs
   * with the answers they already have.
   *
   * @param options as {@link EvaluationOptions#in} returns them
   * @throws DiagnosticException for failures caused by the project or this machine
   */
  public static EvaluationOutcome run(
      Project project, EvaluationOptions options, Listener listener) {
    try (EvaluationFolder folder = EvaluationFolder.open(options.output())) {
      LanguageModelEvaluation evaluation =
          new LanguageModelEvaluation(project, options, listener, folder);
      return new EvaluationResult(project, options, folder, evaluation.runAll()).write();
    }
  }

  /** Returns the JSON Schema of {@code evaluation.json}. */
  public static String schema() {
    return EvaluationJson.schema();
  }

  /** Executes the runs in any order, and returns them in the order of the models. */
  private List<EvaluationRun.Done> runAll() {
    ExecutorService workers = Executors.newFixedThreadPool(options.parallel());
    try {
      List<Future<EvaluationRun.Done>> begun = new ArrayList<>();
      for (String model : options.models()) {
        for (int number = 1; number <= options.runs(); number++) {
          int run = number;
          begun.add(workers.submit(() -> perform(model, run)));
        }
      }
      List<EvaluationRun.Done> done = new ArrayList<>();
      for (Future<EvaluationRun.Done> each : begun) {
        done.add(each.get());
      }
      return done;
    } catch (ExecutionException e) {
      ended = true;
      throw rethrown(e.getCause());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("nobody interrupts an evaluation", e);
    } finally {
      end(workers);
    }
  }

  /** Waits for runs that have begun: after the evaluation, nobody writes into its folder. */
  private static void end(ExecutorService workers) {
    workers.shutdown();
    try {
      workers.awaitTermination(Long.MAX_VALUE, TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static RuntimeException rethrown(Throwable cause) {
    if (cause instanceof Error error) {
      throw error;
    }
    return (RuntimeException) cause;
  }

  private EvaluationRun.Done perform(String model, int number) {
    long start = System.nanoTime();
    String name = EvaluationFolder.nameOf(model, number);
    String inputs = EvaluationFolder.inputs(project, options, model, number, reference);
    Optional<EvaluatedRun> before = folder.finished(name, inputs);
    EvaluationRun.Done done =
        before.isPresent()
            ? new EvaluationRun.Done(before.get(), List.of())
            : ended || unreachable.contains(model)
                ? notBegun(model, number)
                : performNow(model, number, name);
    if (before.isEmpty() && done.run().isCounted()) {
      folder.finish(name, inputs, done.run());
    }
    Duration duration = Duration.ofNanos(System.nanoTime() - start);
    String words = EvaluationText.words(done.run()) + (before.isPresent() ? " (as before)" : "");
    listener.ended(model, number, done.run().isCounted(), duration, words);
    return done;
  }

  private static EvaluationRun.Done notBegun(String model, int number) {
    String reason = State.NOT_BEGUN.words();
    return new EvaluationRun.Done(
        EvaluatedRun.uncounted(model, number, State.NOT_BEGUN, reason), List.of());
  }

  private EvaluationRun.Done performNow(String model, int number, String name) {
    folder.begin(name);
    Path recordings = folder.path(name).resolve(ProjectLayout.RECORDINGS);
    Sample sample = new Sample(model, number - 1, project.recordings(), recordings, spending);
    Optional<AnswerSession> session =
        AnswerSets.of(options.source(project))
            .map(sets -> sets.folders().get(number - 1))
            .map(answers -> new AnswerSession(answers, handoff(name)));
    EvaluationRun.Task task =
        new EvaluationRun.Task(project, runOptions(name), model, number, reference, session);
    EvaluationRun.Done done =
        new EvaluationRun(task, sample, new Steps(model, number, listener)).perform();
    for (Diagnostic finding : done.findings()) {
      ended |= finding.kind().has(AnswerTrait.ENDING);
      if (finding.kind().has(AnswerTrait.LASTING)) {
        unreachable.add(model);
      }
    }
    return done;
  }

  private Path handoff(String name) {
    return folder.path(name).resolve("handoff");
  }

  /**
   * Returns options that run all stages anew, from recorded answers; nobody edits in this folder.
   */
  private RunOptions runOptions(String name) {
    String source = options.source(project);
    boolean ownFolder = source.startsWith(HANDOFF) && source.length() > HANDOFF.length();
    String own =
        AnswerSets.of(source).isPresent()
            ? HANDOFF + handoff(name)
            : ownFolder ? source + "/" + name : source;
    return new RunOptions(
        folder.path(name),
        new Stages(Stage.DESIGN, Stage.REPORT, true),
        new Answers(Optional.of(own), true),
        OnEdit.OVERWRITE,
        SimulationOptions.DEFAULT.with(StrengthExtent.OFF),
        Optional.empty(),
        options.suppressions(),
        options.timeLimit());
  }

  /** Forwards the steps of a run. */
  private record Steps(String model, int run, Listener listener) implements Progress {
    @Override
    public void started(Stage stage) {
      step(stage, stage.purpose());
    }

    @Override
    public void step(Stage stage, String message) {
      listener.step(model, run, stage.title() + ": " + message);
    }

    @Override
    public void ended(Stage stage, Status status, Duration duration, String details) {
      // The result of a run is reported when it has ended.
    }
  }
}
