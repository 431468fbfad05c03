package dev.eventchain.pipeline.report;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.pipeline.design.OfferedSignals;
import dev.eventchain.pipeline.diagram.ChainPicture;
import dev.eventchain.pipeline.project.Configuration;
import dev.eventchain.pipeline.results.AnsweredPrompt;
import dev.eventchain.pipeline.results.Answers;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.results.Simulated;
import dev.eventchain.pipeline.results.StageReport;
import dev.eventchain.pipeline.results.Validated;
import dev.eventchain.pipeline.results.Validation;
import dev.eventchain.pipeline.run.RunResult.Verdict;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.simulate.SimulateStage;
import dev.eventchain.pipeline.stage.ChainSnapshot;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageOutcome;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;

/** Collects the data of the report, from the stages' results and the files of the run. */
public final class ReportData {

  private static final double NANOSECONDS_IN_A_MILLISECOND = 1e6;

  private final RunContext run;
  private final Map<Stage, StageOutcome> outcomes;
  private final EarlierRun before;
  private final Optional<ChainSnapshot> model;
  private final ObjectNode data = JsonNodeFactory.instance.objectNode();

  /**
   * Creates the data of a run.
   *
   * @param before the earlier run that the report compares with
   */
  public ReportData(RunContext run, Map<Stage, StageOutcome> outcomes, EarlierRun before) {
    this.run = run;
    this.outcomes = outcomes;
    this.before = before;
    this.model = readable(run::chain);
  }

  /**
   * Returns the model measured by this run; the model if nothing was measured; else an empty one.
   */
  public EventChain chain() {
    Optional<EventChain> measured =
        outcomes.get(Stage.SIMULATE).report().isPresent()
            ? readable(() -> run.loadChain(run.file(SimulateStage.MEASURED_MODEL)).chain())
            : Optional.empty();
    return measured
        .or(() -> model.map(ChainSnapshot::chain))
        .orElseGet(EventchainFactory.eINSTANCE::createEventChain);
  }

  public ObjectNode collect(Verdict verdict, String summary, List<Diagnostic> found) {
    project(verdict, summary);
    provenance();
    stages();
    model.ifPresent(m -> data.set("chain", ChainPicture.of(m.chain())));
    set("validation", validation());
    offered().ifPresent(it -> data.set("retrieved", it));
    set("conversations", conversations());
    diagnostics(found);
    set("latencies", simulated().map(Simulated::latencies).orElse(List.of()));
    set("processors", simulated().map(Simulated::processors).orElse(List.of()));
    data.set("scenarios", before.beside(simulated().map(Simulated::scenarios).orElse(List.of())));
    set("faults", simulated().map(Simulated::faults).orElse(List.of()));
    set("nodes", simulated().map(Simulated::nodes).orElse(List.of()));
    set("hops", simulated().map(Simulated::hops).orElse(List.of()));
    set("topics", simulated().map(Simulated::topics).orElse(List.of()));
    set("signals", simulated().map(Simulated::signals).orElse(List.of()));
    set("requirements", new Traceability(run, model, outcomes).table());
    return data;
  }

  /** Returns the heading of the page. */
  public ReportPage.Heading heading(Verdict verdict, String summary) {
    Configuration configuration = run.project().configuration();
    return new ReportPage.Heading(configuration.name(), configuration.title(), verdict, summary);
  }

  private void set(String part, List<?> values) {
    data.set(part, ResultJson.tree(values));
  }

  private void project(Verdict verdict, String summary) {
    data.putObject("project")
        .put("name", run.project().configuration().name())
        .put("title", run.project().configuration().title())
        .put("verdict", verdict.name().toLowerCase(Locale.ROOT))
        .put("summary", summary);
  }

  private void provenance() {
    ObjectNode provenance = data.putObject("provenance");
    Configuration configuration = run.project().configuration();
    provenance.put("llm", run.options().answers().source().orElse(configuration.llm()));
    ObjectNode models = provenance.putObject("models");
    for (Stage stage : List.of(Stage.DESIGN, Stage.IMPLEMENT, Stage.MODEL, Stage.CONSTRAIN)) {
      Optional<Answers> answers = report(stage, Answers.class);
      answers.ifPresent(it -> models.put(stage.id(), it.model()));
      answers.ifPresent(it -> provenance.put("recordings", it.provenance()));
    }
    Optional<Answers> tested = report(Stage.IMPLEMENT, Answers.class);
    tested.flatMap(Answers::confinement).ifPresent(it -> provenance.put("confinement", it));
    tested.flatMap(Answers::python).ifPresent(it -> provenance.put("python", it));
    simulated().ifPresent(it -> provenance.put("confinement", it.confinement()));
    simulated().ifPresent(it -> provenance.put("python", it.python()));
    simulated().ifPresent(it -> provenance.put("driver", it.driver()));
    simulated().flatMap(Simulated::strength).ifPresent(it -> provenance.put("strength", it));
    provenance.put("java", System.getProperty("java.version"));
    provenance.put("tool", "eventchain " + version());
  }

  private static String version() {
    String version = ReportData.class.getPackage().getImplementationVersion();
    return version == null ? "(development)" : version;
  }

  /** Returns the prompts to language models and their answers. */
  private List<AnsweredPrompt> conversations() {
    return outcomes.keySet().stream()
        .flatMap(stage -> run.models().conversation(stage).stream())
        .toList();
  }

  /** Returns the signals of a catalogue that the design was offered, if there was one. */
  private Optional<JsonNode> offered() {
    Path file = run.file(OfferedSignals.FILE);
    return run.project().catalogue().isPresent() && Files.isRegularFile(file)
        ? readable(() -> JsonDocument.parse(SourceText.read(file)).root())
        : Optional.empty();
  }

  private void stages() {
    ArrayNode stages = data.putArray("stages");
    for (StageOutcome outcome : outcomes.values()) {
      stages
          .addObject()
          .put("name", outcome.stage().id())
          .put("title", outcome.stage().title())
          .put("status", outcome.status().toString())
          .put("milliseconds", outcome.duration().toNanos() / NANOSECONDS_IN_A_MILLISECOND)
          .put("details", outcome.details());
    }
  }

  /** Returns the value; empty without a readable model, which is then reported elsewhere. */
  private static <T> Optional<T> readable(Supplier<T> reader) {
    try {
      return Optional.of(reader.get());
    } catch (DiagnosticException e) {
      return Optional.empty();
    }
  }

  private List<Validation> validation() {
    return Stream.concat(
            report(Stage.VALIDATE, Validated.class).map(Validated::validation).stream(),
            simulated().map(Simulated::validation).stream())
        .toList();
  }

  private void diagnostics(List<Diagnostic> found) {
    ArrayNode all = data.putArray("diagnostics");
    for (Diagnostic diagnostic : found) {
      all.addObject()
          .put("id", diagnostic.id())
          .put("severity", diagnostic.severity().toString())
          .put("message", Printable.clean(diagnostic.message()))
          .put("file", diagnostic.location().file())
          .put("line", diagnostic.location().line())
          .put("column", diagnostic.location().column())
          .put("element", diagnostic.location().element())
          .put("hint", Printable.clean(diagnostic.hint()))
          .put("rule", diagnostic.rule());
    }
  }

  private Optional<Simulated> simulated() {
    return report(Stage.SIMULATE, Simulated.class);
  }

  private <T extends StageReport> Optional<T> report(Stage stage, Class<T> type) {
    return outcomes.get(stage).report(type);
  }
}
