package dev.eventchain.simulation;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.sandbox.Confinement;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.chain.NodeConfiguration;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.host.HostProgram;
import dev.eventchain.simulation.host.LockstepProcess;
import dev.eventchain.simulation.host.NodeHosts;
import dev.eventchain.simulation.judge.ScenarioJudge;
import dev.eventchain.simulation.node.NodePackage;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.run.ScenarioRunner;
import dev.eventchain.simulation.scenario.Criterion;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.CaseResult.CriterionMargin;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.IntFunction;

/**
 * Simulates many cases of a scenario in lock-step, on all processors. A case is judged by its
 * criteria alone: whether they are evidence for the software is a question about a project's
 * scenarios. Runs are not kept.
 */
public final class CaseSimulation {

  private final SimulationRequest request;
  private final SimulatedChain chain;
  private final NodePackage nodes;
  private final PythonEnvironment python;

  /** A scenario on a bench. */
  public record Case(Scenario scenario, Bench bench) {}

  /** Receives results, one at a time, in an order that depends on the machine. */
  public interface Listener {

    /** Receives the result of a case. */
    void done(int number, CaseResult result);
  }

  /** The numbers of cases, handed out to several threads while others are simulated. */
  public interface Numbers {

    /** Waits for a case; returns empty once there will be none any more. */
    OptionalInt next();

    /** Lets nobody wait any longer, since the simulation ends. */
    void stop();
  }

  /**
   * Creates a simulation.
   *
   * @throws DiagnosticException as {@link Simulation#run} does before it starts a process
   */
  public CaseSimulation(SimulationRequest request, PythonEnvironment python) {
    this.request = request;
    this.chain = request.simulatedChain();
    this.nodes = request.nodePackage();
    this.python = python;
  }

  /**
   * Simulates cases.
   *
   * @param each returns a case by its number, on any thread; a {@link DiagnosticException} is the
   *     result of that case
   * @throws DiagnosticException as {@link Simulation#run} does, except for failures of the software
   *     in a case
   * @throws InterruptedException if the calling thread was interrupted; the processes are ended
   */
  public void run(int cases, IntFunction<Case> each, Listener listener)
      throws InterruptedException {
    HostPool.Job job = (number, hosts) -> work(number, each, hosts, listener);
    new HostPool(cases, this::start, job).run(request.settings().processes());
  }

  /**
   * Simulates cases that are not known at the beginning, as {@link #run(int, IntFunction,
   * Listener)}. No process is started before there is a case for it.
   */
  public void run(Numbers cases, IntFunction<Case> each, Listener listener)
      throws InterruptedException {
    HostPool.Job job = (number, hosts) -> work(number, each, hosts, listener);
    new HostPool(cases, Integer.MAX_VALUE, this::start, job).run(request.settings().processes());
  }

  private HostPool.State work(
      int number, IntFunction<Case> each, NodeHosts hosts, Listener listener) {
    Case own;
    try {
      own = each.apply(number);
    } catch (DiagnosticException e) {
      done(number, CaseResult.error("no scenario: " + e.diagnostics().get(0).message()), listener);
      return HostPool.State.DONE;
    }
    return work(number, own, hosts, listener);
  }

  private synchronized void done(int number, CaseResult result, Listener listener) {
    listener.done(number, result);
  }

  private HostPool.State work(int number, Case own, NodeHosts hosts, Listener listener) {
    SimulatedChain there = chain.on(own.bench());
    NodeConfiguration configuration = new NodeConfiguration(there, nodes);
    ScenarioRunner runner =
        new ScenarioRunner(there, configuration, Optional.empty(), hosts.session(), Map.of());
    try {
      ScenarioJudge judge = new ScenarioJudge(there, List.of(), false);
      done(number, judged(judge, runner.run(own.scenario())), listener);
      return HostPool.State.DONE;
    } catch (DiagnosticException e) {
      if (e.reason() != DiagnosticException.Reason.FINDINGS) {
        throw e;
      }
      done(number, CaseResult.error(e.diagnostics().get(0).message()), listener);
      return HostPool.State.DONE_AT_THE_END;
    }
  }

  /**
   * Returns the result of a case: failed if a criterion failed, passed if one of the scenario was
   * met, none failed and none was left open. Where the premise of another one never came true, this
   * case is none of it.
   */
  static CaseResult judged(ScenarioJudge judge, ScenarioRun run) {
    List<CriterionMargin> criteria = new ArrayList<>();
    List<String> failed = new ArrayList<>();
    List<String> open = new ArrayList<>();
    List<String> untested = new ArrayList<>();
    boolean met = false;
    boolean spared = false;
    for (CriterionResult each : judge.criteriaWithoutEvidence(run)) {
      Expectation criterion = criterion(run, each);
      if (judge.isUnasked(criterion, run)) {
        continue; // correct software need not come to it
      }
      Label own = isSpared(judge, criterion, run) ? Label.PASSED : label(each);
      spared |= own == Label.PASSED && !each.tested();
      criteria.add(margin(each, own));
      met |= own == Label.PASSED && !criterion.isOfEveryScenario();
      if (own != Label.PASSED) {
        List<String> others = judge.isOpen(criterion, run) ? open : untested;
        (own == Label.FAILED ? failed : others).add(each.text() + ": " + each.measured());
      }
    }
    open.addAll(0, unjudgedImpact(run));
    open.addAll(judge.outOfRange(run));
    Label passed = open.isEmpty() && met ? Label.PASSED : Label.UNTESTED;
    Label label = failed.isEmpty() ? passed : Label.FAILED;
    String reason = label == Label.PASSED ? "" : first(List.of(failed, open, untested));
    double end = run.trace().end().time() / 1e9;
    spared &= label == Label.PASSED;
    return new CaseResult(label, reason, criteria, run.trace().impactSpeed(), end, spared);
  }

  private static String first(List<List<String>> reasons) {
    return reasons.stream().flatMap(List::stream).findFirst().orElse("");
  }

  private static List<String> unjudgedImpact(ScenarioRun run) {
    return run.trace().impactSpeed().isPresent() && !run.scenario().judgesImpact()
        ? List.of("an impact, of which no criterion says anything")
        : List.of();
  }

  private static Expectation criterion(ScenarioRun run, CriterionResult result) {
    return run.scenario().criteria().stream()
        .filter(each -> each.location().equals(result.location()))
        .filter(each -> each.text().equals(result.text()))
        .findFirst()
        .orElseThrow();
  }

  /** Returns whether there was no impact since nothing was ahead, which holds in a case. */
  private static boolean isSpared(ScenarioJudge judge, Expectation criterion, ScenarioRun run) {
    return criterion instanceof Criterion known
        && known.limitsImpacts()
        && run.trace().impactSpeed().isEmpty()
        && judge.isOfNothingAhead(criterion, run);
  }

  private static Label label(CriterionResult result) {
    if (!result.tested()) {
      return Label.UNTESTED;
    }
    return result.passed() ? Label.PASSED : Label.FAILED;
  }

  private static CriterionMargin margin(CriterionResult criterion, Label label) {
    return new CriterionMargin(
        criterion.text(),
        label,
        criterion.margin().stream().mapToDouble(Margin::value).findFirst(),
        criterion.margin().map(Margin::unit).orElse(""));
  }

  private NodeHosts start(int turn) {
    HostProgram program = new HostProgram(nodes, python, Confinement.detect());
    return new LockstepProcess(program, request.chain().getSoftware().size(), turn);
  }
}
