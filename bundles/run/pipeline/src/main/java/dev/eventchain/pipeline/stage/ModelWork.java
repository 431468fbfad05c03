package dev.eventchain.pipeline.stage;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.agents.AgentContext;
import dev.eventchain.agents.AgentResult;
import dev.eventchain.agents.Exchange;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.llm.ModelAccess;
import dev.eventchain.llm.Spending;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.pipeline.project.Configuration;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.simulation.SimulationResult;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;

/**
 * What a run has to do with language models: how its stages ask them, what was said, what it cost,
 * and what came of a verdict.
 */
public final class ModelWork {
  private final RunContext run;
  private final Optional<Sample> sample;
  private final Spending spending;
  private final Map<Stage, ArrayNode> conversations = new EnumMap<>(Stage.class);
  private Map<String, AgentResult> corrections = Map.of();
  private Optional<SimulationResult> simulated = Optional.empty();

  /**
   * What a run has not asked yet.
   *
   * @param sample the run of an evaluation that this is, if it is one
   */
  ModelWork(RunContext run, Optional<Sample> sample) {
    this.run = run;
    this.sample = sample;
    this.spending =
        sample
            .map(Sample::spending)
            .orElseGet(() -> new Spending(run.project().configuration().services()));
  }

  /** Whether this is a run by which a language model is evaluated. */
  public boolean isEvaluated() {
    return sample.isPresent();
  }

  /** What the agent of a stage works with. */
  public AgentContext agent(Stage stage) {
    return agent(stage, stage.id());
  }

  /**
   * What an agent works with.
   *
   * @param task which the configuration names models for
   */
  public AgentContext agent(Stage stage, String task) {
    return agent(stage, task, task);
  }

  /** What the correction of a component by a verdict works with. */
  public AgentContext correcting() {
    return agent(Stage.IMPLEMENT, Stage.IMPLEMENT.id(), "verdict");
  }

  private AgentContext agent(Stage stage, String task, String purpose) {
    Configuration configuration = run.project().configuration();
    ModelAccess access =
        new ModelAccess(
            run.options().llm().orElse(configuration.llm()),
            run.project().recordings(),
            run.options().record(),
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
        model,
        configuration.repairs(),
        finding -> run.options().suppressions().accepts(placed(finding)),
        message -> run.progress().step(stage, message),
        exchange -> conversation(stage).add(said(exchange)));
  }

  /** A finding in an answer where it is in the file that the answer becomes. */
  public Diagnostic placed(Diagnostic finding) {
    SourceLocation place = finding.location();
    return becomesFile(place.file())
        ? finding.withLocation(place.inFile(run.file(place.file())))
        : finding;
  }

  /** What an answer is about may be wrong elsewhere, such as in a message definition. */
  private static boolean becomesFile(String name) {
    return name.equals(ProjectFolder.DESCRIPTION)
        || name.equals(ProjectFolder.GENERATED)
        || name.startsWith(ComponentFiles.FOLDER + "/");
  }

  private static ObjectNode said(Exchange exchange) {
    ObjectNode said = JsonNodeFactory.instance.objectNode();
    said.put("task", exchange.task())
        .put("file", exchange.file())
        .put("model", exchange.answer().model())
        .put("provenance", exchange.answer().provenance())
        .put("question", exchange.question())
        .put("answer", exchange.answer().text());
    exchange
        .answer()
        .usage()
        .ifPresent(
            usage ->
                said.put("inputTokens", usage.inputTokens())
                    .put("outputTokens", usage.outputTokens()));
    ArrayNode findings = said.putArray("findings");
    exchange
        .findings()
        .forEach(
            finding ->
                findings
                    .addObject()
                    .put("id", finding.id())
                    .put("severity", finding.severity().toString())
                    .put("message", finding.message()));
    return said;
  }

  /** All that a stage has asked, with the answers; those of earlier runs first. */
  public ArrayNode conversation(Stage stage) {
    return conversations.computeIfAbsent(stage, each -> JsonNodeFactory.instance.arrayNode());
  }

  /** Takes up what an earlier run, whose result stands, has asked. */
  public void recall(Stage stage, JsonNode report) {
    if (report.path("conversation").isArray()) {
      conversation(stage).removeAll();
      report.path("conversation").forEach(conversation(stage)::add);
    }
  }

  /** Components as a language model corrected them after a verdict, by their names. */
  public Map<String, AgentResult> corrections() {
    return corrections;
  }

  /** Takes on components that a language model corrected after a verdict. */
  public void correct(Map<String, AgentResult> corrected) {
    corrections = Map.copyOf(corrected);
  }

  /** What was simulated last in this run, if anything was. */
  public Optional<SimulationResult> simulated() {
    return simulated;
  }

  /** Remembers what was simulated. */
  public void simulated(SimulationResult result) {
    simulated = Optional.of(result);
  }

  /** What the calls of language models have cost in this run. */
  public Spending spending() {
    return spending;
  }
}
