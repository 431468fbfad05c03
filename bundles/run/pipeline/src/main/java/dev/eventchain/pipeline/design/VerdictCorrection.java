package dev.eventchain.pipeline.design;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.agents.AgentContext;
import dev.eventchain.agents.AgentResult;
import dev.eventchain.agents.DesignAgent;
import dev.eventchain.agents.DiagnoseAgent;
import dev.eventchain.agents.Diagnosis;
import dev.eventchain.agents.ImplementAgent;
import dev.eventchain.agents.TestAgent;
import dev.eventchain.agents.component.ComponentTester;
import dev.eventchain.description.EventChainSchema;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.llm.chat.AnswerRules;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.Correction;
import dev.eventchain.pipeline.stage.FailedVerdict;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.sandbox.ComponentProbe;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;

/**
 * Sends a failed verdict back to language models: one looks for what is wrong, and the author of
 * that corrects it. If it is a requirement, or something that people wrote, a person is asked.
 */
public final class VerdictCorrection {
  private final RunContext run;
  private final FailedVerdict failed;
  private final SourceText chain;

  /** Creates the correction of the last simulation of a run. */
  public VerdictCorrection(RunContext run) {
    this.run = run;
    this.failed = run.models().failed(FailedScenarios::of).orElseThrow();
    this.chain = SourceText.read(run.required(ProjectFolder.DESCRIPTION, Stage.DESIGN));
  }

  /** Returns whether the run writes components and has simulated all scenarios. */
  public static boolean isAllowed(RunContext run) {
    return mayFollow(run.options()) && run.models().isJudged();
  }

  /** Returns whether a run writes components and simulates all scenarios with them. */
  public static boolean mayFollow(RunOptions options) {
    return options.runs(Stage.IMPLEMENT)
        && !options.isPartial()
        && !options
            .simulation()
            .isAttached(); // changes here do not affect nodes that were started elsewhere
  }

  /**
   * Requests a correction.
   *
   * @return empty if nobody can correct anything: no criterion failed, nobody answered, or a person
   *     has to decide; {@link Correction#NONE} if an author found no fault, so that another
   *     diagnosis may help
   * @throws DiagnosticException WAITING for a person's answer
   */
  public Optional<Correction> ask() {
    List<SoftwareNode> path = path();
    boolean anythingWritten = !run.softwareBase().missing(run.chain().chain()).isEmpty();
    if (!failed.anyFailed() || !anythingWritten) {
      return Optional.empty();
    }
    Optional<Diagnosis> diagnosis = orNobody(() -> diagnose(path), "a diagnosis");
    diagnosis.ifPresent(run.models().diagnoses()::add);
    return diagnosis.flatMap(this::correct);
  }

  /** Returns the components whose outputs can reach what failed, in chain order. */
  private List<SoftwareNode> path() {
    return run.chain().chain().getSoftware().stream()
        .filter(node -> failed.path().contains(node.getName()))
        .toList();
  }

  private Diagnosis diagnose(List<SoftwareNode> path) {
    StandingDiagnoses.restore(run);
    run.progress().step(Stage.SIMULATE, "asking what is wrong");
    DiagnoseAgent.Failure failure =
        new DiagnoseAgent.Failure(
            chain,
            path.stream().map(SoftwareNode::getName).toList(),
            written(path),
            new FailureText(run).code(written(path)),
            failed.text(),
            run.models().diagnoses());
    return new DiagnoseAgent(run.models().correcting(Stage.IMPLEMENT, "diagnose"))
        .diagnose(failure, run.requirements());
  }

  /** Returns the components that a language model wrote and nobody edited. */
  private List<String> written(List<SoftwareNode> path) {
    List<SoftwareNode> missing = run.softwareBase().missing(run.chain().chain());
    return path.stream()
        .filter(missing::contains)
        .map(SoftwareNode::getName)
        .filter(name -> !run.output().isEdited(ComponentFiles.name(name)))
        .toList();
  }

  private Optional<Correction> correct(Diagnosis diagnosis) {
    String name = diagnosis.name();
    return switch (diagnosis.wrong()) {
      case COMPONENT ->
          corrected(name, new TestFiles(run, chain).standing(name), diagnosis)
              .map(
                  code ->
                      isAnother(code, present(name))
                          ? Correction.of(name, code, Optional.empty())
                          : Correction.NONE);
      case TEST ->
          TestFiles.isWritten(run.project(), name)
              ? person(diagnosis, "The tests of " + name + ", which people wrote, may be wrong: ")
              : correctedTests(diagnosis);
      case DESIGN ->
          run.project().editedModel().isPresent()
              ? person(diagnosis, "The design, which people edit, may be wrong: ")
              : correctedDesign(diagnosis);
      case REQUIREMENT ->
          person(diagnosis, "No design may be able to do all that is asked for (" + name + "): ");
    };
  }

  /** Ends the corrections with a question to a person. */
  private Optional<Correction> person(Diagnosis diagnosis, String about) {
    run.find(
        Diagnostic.of(
                DesignRules.AGENTS_VERDICT_QUESTION,
                about + diagnosis.why(),
                SourceLocation.of(run.project().firstRequirements()))
            .withHint("Decide, change it, and run again; the failed criteria are named above."));
    return Optional.empty();
  }

  private Optional<AgentResult> corrected(String name, ComponentTester tests, Diagnosis diagnosis) {
    SoftwareNode node =
        path().stream().filter(it -> name.equals(it.getName())).findFirst().orElseThrow();
    run.progress().step(Stage.SIMULATE, "asking for a correction of " + name);
    return orNobody(
        () ->
            new ImplementAgent(
                    run.models().correcting(Stage.IMPLEMENT, Stage.IMPLEMENT.id()),
                    new ComponentProbe(run.python(Stage.IMPLEMENT)),
                    run.softwareBase().signals().orElse(List.of()))
                .correct(
                    chain,
                    name,
                    run.requirements(),
                    Optional.of(tests),
                    present(name),
                    failed.texts().get(node.getName()),
                    diagnosis.why()),
        "a correction of '" + name + "'");
  }

  private SourceText present(String component) {
    return SourceText.read(run.file(ComponentFiles.name(component)));
  }

  private static boolean isAnother(AgentResult answered, SourceText present) {
    return !answered.text().equals(present.text());
  }

  /** Returns corrected tests, and the component that was corrected by them, if it had to be. */
  private Optional<Correction> correctedTests(Diagnosis diagnosis) {
    String name = diagnosis.name();
    TestFiles files = new TestFiles(run, chain);
    run.progress().step(Stage.SIMULATE, "asking for other tests of " + name);
    Optional<AgentResult> tests =
        orNobody(
            () ->
                new TestAgent(run.models().correcting(Stage.IMPLEMENT, "test"))
                    .correct(
                        chain, name, run.requirements(), files.proposal(name), diagnosis.why()),
            "other tests of '" + name + "'");
    return tests
        .flatMap(it -> corrected(name, files.read(it, name), diagnosis))
        .map(code -> Correction.of(name, code, tests));
  }

  private Optional<Correction> correctedDesign(Diagnosis diagnosis) {
    run.progress().step(Stage.SIMULATE, "asking for another design");
    AgentContext context = run.models().correcting(Stage.DESIGN, Stage.DESIGN.id());
    Optional<AgentResult> design =
        orNobody(
            () ->
                new DesignAgent(context)
                    .correct(DesignStage.asked(run), chain, failed.text(), diagnosis.why()),
            "another design");
    return design.map(
        answered ->
            isAnother(answered, chain)
                ? Correction.of(answered, unchangedBy(answered))
                : Correction.NONE);
  }

  /** Returns the components whose description another design leaves as it is. */
  private Set<String> unchangedBy(AgentResult design) {
    SourceText text = SourceText.of(ProjectFolder.DESCRIPTION, design.text());
    Set<JsonNode> before = new HashSet<>();
    EventChainSchema.components(JsonDocument.parse(chain).root()).forEach(before::add);
    Set<String> kept = new HashSet<>();
    EventChainSchema.components(JsonDocument.parse(text).root())
        .forEach(
            each -> {
              if (before.contains(each)) {
                kept.add(each.path("name").asText());
              }
            });
    return kept;
  }

  /** Returns the answer; empty, with a finding, if there is none that can be used. */
  private <T> Optional<T> orNobody(Supplier<T> question, String what) {
    try {
      return Optional.of(question.get());
    } catch (DiagnosticException e) {
      // The result of an evaluation with a correction would be unknown.
      boolean evaluated = run.models().isEvaluated() && e.reason() != Reason.FINDINGS;
      if (e.reason() == Reason.WAITING || evaluated) {
        throw e;
      }
      Diagnostic first = e.diagnostics().get(0);
      if (!first.is(AnswerRules.RECORDING_MISSING)) {
        run.find(
            Diagnostic.of(
                    DesignRules.AGENTS_VERDICT_UNCORRECTED,
                    "The failed scenarios were sent back for %s without success: %s"
                        .formatted(what, first.message()),
                    SourceLocation.of(run.file(ProjectFolder.DESCRIPTION)))
                .withHint(first.hint()));
      }
      return Optional.empty();
    }
  }
}
