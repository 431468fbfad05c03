package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.sandbox.Confinement;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.chain.NodeConfiguration;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.host.HostProgram;
import dev.eventchain.simulation.host.LockstepProcess;
import dev.eventchain.simulation.host.NodeHosts;
import dev.eventchain.simulation.judge.ScenarioJudge;
import dev.eventchain.simulation.node.NodePackage;
import dev.eventchain.simulation.node.Replacements;
import dev.eventchain.simulation.run.ScenarioRunner;
import dev.eventchain.simulation.strength.StrengthTrials;
import dev.eventchain.simulation.variant.PassedScenario;
import dev.eventchain.simulation.variant.VariantTrial;
import dev.eventchain.simulation.verdict.VariantReaction;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Simulates variants of components and of modules that these import in the scenarios that pass with
 * the components as they are, in lock-step. A process reads the component again for each scenario,
 * so a few processes are enough for all variants.
 */
public final class VariantSimulation {

  /** Times that the end of a process has to be repeated, in new processes, to be evidence. */
  public static final int REPETITIONS = 2;

  private final SimulationRequest request;
  private final SimulatedChain chain;
  private final NodePackage original;
  private final PythonEnvironment python;
  private final Map<Integer, Ends> ends = new ConcurrentHashMap<>();

  /** The ends of processes in a scenario of a variant: the reaction, and how often it came. */
  private record Ends(VariantReaction reaction, int times) {}

  /**
   * The components as they are, in all scenarios.
   *
   * @param failed the findings about scenarios that fail with them, so that nothing was tried
   * @param ended the findings that a process ended in a scenario, each time: one for each scenario,
   *     which tells nothing about variants
   */
  public record Original(List<Diagnostic> failed, List<Diagnostic> ended) {

    /** Copies the lists. */
    public Original {
      failed = List.copyOf(failed);
      ended = List.copyOf(ended);
    }
  }

  /** Receives reactions, one at a time, in an order that depends on the machine. */
  public interface Listener {

    /** Receives the reaction to a variant. */
    void reacted(int variant, VariantReaction reaction);
  }

  /**
   * Creates a simulation.
   *
   * @param folder the folder with the files of all variants
   * @throws dev.eventchain.diagnostics.DiagnosticException as {@link Simulation#run} does before it
   *     starts a process
   */
  public VariantSimulation(SimulationRequest request, PythonEnvironment python, Path folder) {
    this.request = request;
    this.chain = request.simulatedChain();
    this.original = request.nodePackage().withVariants(folder);
    this.python = python;
  }

  /**
   * Simulates each variant until a scenario notices it. Nothing is known of those that none
   * notices, if there is a scenario in which the process ends without them, too.
   *
   * @param same a copy of each component, which is loaded as the variants are, to learn what the
   *     scenarios do without a defect
   * @return what these copies do
   * @throws dev.eventchain.diagnostics.DiagnosticException as {@link Simulation#run} does, except
   *     for failures of a variant
   * @throws InterruptedException if the calling thread was interrupted; the processes are ended
   */
  public Original run(List<Replacements> same, List<Replacements> variants, Listener listener)
      throws InterruptedException {
    OriginalRuns runs = new OriginalRuns(request.scenarios());
    new HostPool(
            request.scenarios().size(),
            this::start,
            (number, hosts) -> runs.drive(number, runner(same, hosts)))
        .run(request.settings().processes());
    ScenarioJudge judge = new ScenarioJudge(chain, runs.done(), runs.ended().isEmpty());
    List<Diagnostic> failed =
        runs.done().stream()
            .flatMap(run -> judge.verdict(run, true).diagnostics().stream())
            .filter(finding -> !request.settings().accepted().test(finding))
            .toList();
    if (failed.isEmpty()) {
      List<PassedScenario> passed =
          runs.done().stream()
              .map(run -> new PassedScenario(run, judge))
              .sorted(PassedScenario.ORDER)
              .toList();
      VariantTrial trial = new VariantTrial(passed, runs.ended().stream().findFirst());
      HostPool.Job job = (number, hosts) -> work(number, same, variants, trial, hosts, listener);
      new HostPool(variants.size(), this::start, job).run(request.settings().processes());
    }
    return new Original(failed, runs.ended());
  }

  private HostPool.State work(
      int number,
      List<Replacements> same,
      List<Replacements> variants,
      VariantTrial trial,
      NodeHosts hosts,
      Listener listener) {
    ScenarioRunner runner = runner(List.of(variants.get(number)), hosts);
    Ends before = ends.get(number);
    VariantReaction reaction =
        before == null
            ? trial.run(runner)
            : trial.repeat(before.reaction(), runner(same, hosts), runner);
    int times = before == null ? 0 : before.times();
    if (reaction.kind() == VariantReaction.Kind.ENDED && times < REPETITIONS) {
      ends.put(number, new Ends(reaction, times + 1));
      return HostPool.State.UNDONE;
    }
    synchronized (this) {
      listener.reacted(number, reaction);
    }
    return switch (reaction.kind()) {
      case RAISED, ENDED, UNPROVED -> HostPool.State.DONE_AT_THE_END;
      default -> HostPool.State.DONE;
    };
  }

  private ScenarioRunner runner(List<Replacements> loaded, NodeHosts hosts) {
    NodePackage nodes = original;
    for (Replacements files : loaded) {
      nodes = nodes.with(files);
    }
    Map<String, List<String>> recorded = StrengthTrials.recorded(chain);
    return new ScenarioRunner(
        chain, new NodeConfiguration(chain, nodes), Optional.empty(), hosts.session(), recorded);
  }

  private NodeHosts start(int turn) {
    HostProgram program = new HostProgram(original, python, Confinement.detect());
    return new LockstepProcess(program, request.chain().getSoftware().size(), turn);
  }
}
