package dev.eventchain.pipeline.design;

import dev.eventchain.agents.AgentResult;
import dev.eventchain.agents.ImplementAgent;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.chat.AnswerRules;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.sandbox.ComponentProbe;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Sends a failed verdict back to the language model that wrote the components: to one after the
 * other, in the order of the chain, until one is changed. Components whose outputs reach no signal
 * of a failed criterion are not asked.
 */
public final class VerdictCorrection {
  private final RunContext run;
  private final List<ScenarioVerdict> failed;
  private final Map<String, Scenario> scenarios;

  private VerdictCorrection(RunContext run, List<ScenarioVerdict> failed) {
    this.run = run;
    this.failed = failed;
    this.scenarios =
        Scenario.readFolder(run.project().scenarios(), run.chain().bench(), warning -> {}).stream()
            .collect(Collectors.toMap(Scenario::name, scenario -> scenario));
  }

  /** Returns whether the run writes components and has simulated all scenarios. */
  public static boolean isAllowed(RunContext run) {
    return run.options().runs(Stage.IMPLEMENT)
        && !run.options().isPartial()
        && !run.options()
            .isAttached() // changes here do not affect nodes that were started elsewhere
        && run.models().simulated().isPresent();
  }

  /**
   * Requests a correction.
   *
   * @return the changed component by name; empty if no scenario fails by a criterion, or no
   *     component was changed
   * @throws DiagnosticException WAITING for a person's answer
   */
  public static Map<String, AgentResult> ask(RunContext run, SimulationResult simulated) {
    List<ScenarioVerdict> failed =
        simulated.verdicts().stream()
            .filter(verdict -> verdict.worked() && !VerdictText.failed(verdict).isEmpty())
            .toList();
    return failed.isEmpty() ? Map.of() : new VerdictCorrection(run, failed).ask();
  }

  private Map<String, AgentResult> ask() {
    Set<String> requirements =
        failed.stream()
            .flatMap(verdict -> VerdictText.failed(verdict).stream())
            .flatMap(criterion -> criterion.requirements().stream())
            .collect(Collectors.toSet());
    for (SoftwareNode node : run.softwareBase().missing(run.chain().chain())) {
      boolean concerned =
          node.getSatisfies().stream().map(Requirement::getId).anyMatch(requirements::contains);
      if (concerned
          && mayBeTheCause(node)
          && !run.output().isEdited(ComponentFiles.name(node.getName()))) {
        Optional<AgentResult> corrected = ask(node);
        if (corrected.isPresent()) {
          return Map.of(node.getName(), corrected.get());
        }
      }
    }
    return Map.of();
  }

  /** Returns whether what a component writes can reach a signal that a failed criterion reads. */
  private boolean mayBeTheCause(SoftwareNode node) {
    Set<String> topics = TopicIndex.of(run.chain().chain()).influencedBy(List.of(node));
    return failed.stream()
        .anyMatch(
            verdict ->
                VerdictText.failed(verdict).stream()
                    .anyMatch(missed -> dependsOn(verdict, missed, topics)));
  }

  private boolean dependsOn(ScenarioVerdict verdict, CriterionResult missed, Set<String> topics) {
    return Optional.ofNullable(scenarios.get(verdict.scenario()))
        .map(scenario -> scenario.dependsOn(missed.location(), topics, run.chain().bench()))
        .orElse(true);
  }

  private Optional<AgentResult> ask(SoftwareNode node) {
    Path file = run.file(ComponentFiles.name(node.getName()));
    SourceText present = SourceText.read(file);
    run.progress().step(Stage.SIMULATE, "asking for a correction of " + node.getName());
    try {
      AgentResult answered = correct(node, present);
      return answered.text().equals(present.text()) ? Optional.empty() : Optional.of(answered);
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
                    "The failed scenarios were sent back to the model of '%s' without success: %s"
                        .formatted(node.getName(), first.message()),
                    SourceLocation.of(file))
                .withHint(first.hint()));
      }
      return Optional.empty();
    }
  }

  private AgentResult correct(SoftwareNode node, SourceText present) {
    SourceText chain = SourceText.read(run.required(ProjectFolder.DESCRIPTION, Stage.DESIGN));
    return new ImplementAgent(
            run.models().correcting(), new ComponentProbe(run.python(Stage.IMPLEMENT)))
        .correct(
            chain,
            node.getName(),
            run.requirements(),
            Optional.of(new TestFiles(run, chain).standing(node.getName())),
            present,
            VerdictText.of(node, failed));
  }
}
