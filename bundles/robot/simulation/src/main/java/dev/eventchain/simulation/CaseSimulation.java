package dev.eventchain.simulation;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.sandbox.Confinement;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.chain.NodeConfiguration;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.host.HostProgram;
import dev.eventchain.simulation.host.LockstepProcess;
import dev.eventchain.simulation.host.NodeHosts;
import dev.eventchain.simulation.judge.ScenarioJudge;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.run.ScenarioRunner;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.stream.Collectors;

/**
 * Simulates many cases of a scenario in lock-step, on all processors. A case is judged by its
 * criteria alone: whether they are evidence for the software is a question about a project's
 * scenarios. Runs are not kept.
 */
public final class CaseSimulation {

  private final SimulationRequest request;
  private final SimulatedChain chain;
  private final NodeConfiguration nodes;
  private final ScenarioJudge judge;
  private final PythonEnvironment python;

  /** Receives results, one at a time, in an order that depends on the machine. */
  public interface Listener {

    /** Receives the result of a case. */
    void done(int number, CaseResult result);
  }

  /**
   * Creates a simulation.
   *
   * @throws DiagnosticException as {@link Simulation#run} does before it starts a process
   */
  public CaseSimulation(SimulationRequest request, PythonEnvironment python) {
    this.request = request;
    this.chain = request.simulatedChain();
    this.nodes = new NodeConfiguration(chain, request.nodePackage());
    this.judge = new ScenarioJudge(chain, List.of(), false);
    this.python = python;
  }

  /**
   * Simulates cases.
   *
   * @param scenarios returns a case by its number, on any thread
   * @throws DiagnosticException as {@link Simulation#run} does, except for failures of the software
   *     in a case
   * @throws InterruptedException if the calling thread was interrupted; the processes are ended
   */
  public void run(int cases, IntFunction<Scenario> scenarios, Listener listener)
      throws InterruptedException {
    HostPool.Job job = (number, hosts) -> work(number, scenarios.apply(number), hosts, listener);
    new HostPool(cases, this::start, job).run(request.settings().processes());
  }

  private HostPool.State work(int number, Scenario scenario, NodeHosts hosts, Listener listener) {
    ScenarioRunner runner =
        new ScenarioRunner(chain, nodes, Optional.empty(), hosts.session(), Map.of());
    try {
      CaseResult result = judged(runner.run(scenario));
      synchronized (this) {
        listener.done(number, result);
      }
      return HostPool.State.DONE;
    } catch (DiagnosticException e) {
      if (e.reason() != DiagnosticException.Reason.FINDINGS) {
        throw e;
      }
      synchronized (this) {
        listener.done(number, CaseResult.error(e.diagnostics().get(0).message()));
      }
      return HostPool.State.DONE_AT_THE_END;
    }
  }

  private CaseResult judged(ScenarioRun run) {
    List<CriterionResult> criteria = asked(run);
    boolean unjudged = run.trace().impactSpeed().isPresent() && !run.scenario().judgesImpact();
    Label label = unjudged ? Label.UNTESTED : Label.PASSED;
    for (Label worse : List.of(Label.UNTESTED, Label.FAILED)) {
      label = criteria.stream().anyMatch(each -> label(each) == worse) ? worse : label;
    }
    Label decided = label;
    String reason =
        criteria.stream()
            .filter(each -> decided != Label.PASSED && label(each) == decided)
            .map(each -> each.text() + ": " + each.measured())
            .findFirst()
            .orElse(unjudged ? "an impact, of which no criterion says anything" : "");
    return new CaseResult(
        label,
        reason,
        criteria.stream().map(CaseSimulation::margin).toList(),
        run.trace().impactSpeed(),
        run.trace().end().time() / 1e9);
  }

  /** Returns the results of the criteria, without optional ones whose premise did not come true. */
  private List<CriterionResult> asked(ScenarioRun run) {
    Set<SourceLocation> unasked =
        run.scenario().criteria().stream()
            .filter(each -> judge.isUnasked(each, run))
            .map(Expectation::location)
            .collect(Collectors.toSet());
    return judge.criteriaWithoutEvidence(run).stream()
        .filter(each -> each.tested() || !unasked.contains(each.location()))
        .toList();
  }

  private static CriterionMargin margin(CriterionResult criterion) {
    return new CriterionMargin(
        criterion.text(),
        label(criterion),
        criterion.margin().stream().mapToDouble(Margin::value).findFirst(),
        criterion.margin().map(Margin::unit).orElse(""));
  }

  private static Label label(CriterionResult criterion) {
    if (!criterion.tested()) {
      return Label.UNTESTED;
    }
    return criterion.passed() ? Label.PASSED : Label.FAILED;
  }

  private NodeHosts start(int turn) {
    HostProgram program = new HostProgram(request.nodePackage(), python, Confinement.detect());
    return new LockstepProcess(program, request.chain().getSoftware().size(), turn);
  }
}
