package dev.eventchain.pipeline.stage;

import dev.eventchain.agents.AgentContext;
import dev.eventchain.agents.Diagnosis;
import dev.eventchain.agents.Exchange;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.llm.ModelAccess;
import dev.eventchain.llm.Spending;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.pipeline.project.Configuration;
import dev.eventchain.pipeline.results.AnsweredPrompt;
import dev.eventchain.pipeline.results.AnsweredPrompt.Finding;
import dev.eventchain.pipeline.results.Answers;
import dev.eventchain.pipeline.results.StageReport;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.simulation.SimulationResult;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;

/**
 * The use of language models in a run: access, conversations, cost, and corrections after a
 * verdict.
 */
public final class ModelWork {
  private final RunContext run;
  private final Optional<Sample> sample;
  private final Spending spending;
  private final Map<Stage, List<AnsweredPrompt>> conversations = new EnumMap<>(Stage.class);
  private Correction correction = Correction.NONE;
  private final List<Diagnosis> diagnoses = new ArrayList<>();
  private Optional<SimulationResult> simulated = Optional.empty();
  private Optional<FailedVerdict> failed = Optional.empty();

  /**
   * Creates the state of a run without calls.
   *
   * @param sample the sample, if this is the run of an evaluation
   */
  ModelWork(RunContext run, Optional<Sample> sample) {
    this.run = run;
    this.sample = sample;
    this.spending =
        sample
            .map(Sample::spending)
            .orElseGet(() -> new Spending(run.project().configuration().services()));
  }

  /** Returns whether this run is part of an evaluation of a language model. */
  public boolean isEvaluated() {
    return sample.isPresent();
  }

  /** Returns the context of a stage's agent. */
  public AgentContext agent(Stage stage) {
    return agent(stage, stage.id());
  }

  /**
   * Returns the context of an agent.
   *
   * @param task a task with models in the configuration
   */
  public AgentContext agent(Stage stage, String task) {
    return agent(stage, task, task);
  }

  /**
   * Returns the context of an agent that works on a failed verdict.
   *
   * @param task a task with models in the configuration
   */
  public AgentContext correcting(Stage stage, String task) {
    return agent(stage, task, "verdict");
  }

  private AgentContext agent(Stage stage, String task, String purpose) {
    Configuration configuration = run.project().configuration();
    ModelAccess access =
        new ModelAccess(
            run.options().answers().source().orElse(configuration.llm()),
            run.project().recordings(),
            run.options().answers().record(),
            configuration.services(),
            spending,
            System::getenv,
            message -> run.progress().step(stage, message),
            run::find);
    ChatModel model =
        sample
            .map(asked -> asked.open(access, purpose))
            .orElseGet(() -> ChatModels.open(access, configuration.models(task)));
    return new AgentContext(
        // Recordings and answers are means of the stage, not sources of its result.
        request -> FileReads.unrecorded(() -> model.chat(request)),
        configuration.repairs(),
        finding -> run.options().suppressions().accepts(placed(finding)),
        message -> run.progress().step(stage, message),
        exchange -> {
          conversation(stage).add(said(exchange));
          sample.ifPresent(it -> it.add(purpose, exchange));
        },
        run::messages);
  }

  /** Returns a finding in an answer, located in the file that is written from the answer. */
  public Diagnostic placed(Diagnostic finding) {
    SourceLocation place = finding.location();
    return becomesFile(place.file())
        ? finding.withLocation(place.inFile(run.file(place.file())))
        : finding;
  }

  /**
   * Returns whether an answer is written to this file; findings may concern others, such as message
   * definitions.
   */
  private static boolean becomesFile(String name) {
    return name.equals(ProjectFolder.DESCRIPTION)
        || name.equals(ProjectFolder.GENERATED)
        || name.startsWith(ComponentFiles.FOLDER + "/");
  }

  private static AnsweredPrompt said(Exchange exchange) {
    Optional<ChatResponse.Usage> usage = exchange.answer().usage();
    return new AnsweredPrompt(
        exchange.task(),
        exchange.file(),
        exchange.answer().model(),
        exchange.answer().provenance(),
        exchange.question(),
        exchange.answer().text(),
        usage.stream().mapToLong(ChatResponse.Usage::inputTokens).findFirst(),
        usage.stream().mapToLong(ChatResponse.Usage::outputTokens).findFirst(),
        exchange.findings().stream()
            .map(it -> new Finding(it.id(), it.severity().toString(), it.message()))
            .toList());
  }

  /** Returns all prompts of a stage with their answers; those of earlier runs first. */
  public List<AnsweredPrompt> conversation(Stage stage) {
    return conversations.computeIfAbsent(stage, each -> new ArrayList<>());
  }

  /** Restores the conversations of an earlier run whose result is still valid. */
  public void recall(Stage stage, StageReport report) {
    if (report instanceof Answers answers) {
      conversations.put(stage, new ArrayList<>(answers.conversation()));
    }
  }

  /** Returns what language models corrected after the last verdict. */
  public Correction correction() {
    return correction;
  }

  /** Adopts what language models corrected after a verdict. */
  public void correct(Correction corrected) {
    correction = corrected;
  }

  /** Returns what was found to be wrong after the verdicts of this run, in their order. */
  public List<Diagnosis> diagnoses() {
    return diagnoses;
  }

  /** Returns the last simulation in this run, if there was one. */
  public Optional<SimulationResult> simulated() {
    return simulated;
  }

  /** Stores the simulation. */
  public void simulated(SimulationResult result) {
    simulated = Optional.of(result);
    failed = Optional.empty();
  }

  /**
   * Returns whether there is a verdict that may be sent back: of this run, or of an earlier one.
   */
  public boolean isJudged() {
    return simulated.isPresent() || failed.isPresent();
  }

  /**
   * Returns what language models are told about the last verdict, if there is one.
   *
   * @param reader returns it for a simulation
   */
  public Optional<FailedVerdict> failed(
      BiFunction<RunContext, SimulationResult, FailedVerdict> reader) {
    failed = failed.or(() -> simulated.map(result -> reader.apply(run, result)));
    return failed;
  }

  /** Stores what they were told about the verdict of an earlier run, which stands. */
  public void failed(FailedVerdict earlier) {
    failed = Optional.of(earlier);
  }

  /** Returns what they were told in this run, if they were asked. */
  public Optional<FailedVerdict> told() {
    return failed;
  }

  /** Returns the cost of language model calls in this run. */
  public Spending spending() {
    return spending;
  }
}
