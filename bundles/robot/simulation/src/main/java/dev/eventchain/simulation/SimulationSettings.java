package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.simulation.fault.FaultPlan;
import dev.eventchain.simulation.node.DdsAttachment;
import dev.eventchain.simulation.node.NodeLimits;
import dev.eventchain.simulation.verdict.StrengthBudget;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;

/** Settings of a simulation: how its nodes run, and what is measured. Immutable. */
public final class SimulationSettings {

  /**
   * Two processes in lock-step with the default limits; no component counts as generated, and
   * strength is not measured.
   */
  public static final SimulationSettings DEFAULT = new SimulationSettings();

  private int processes = 2;
  private Set<String> generated = Set.of();
  private NodeLimits limits = NodeLimits.DEFAULT;
  private Predicate<Diagnostic> accepted = finding -> false;
  private Optional<Path> recordings = Optional.empty();
  private SimulationDriver driver = SimulationDriver.LOCKSTEP;
  private FaultPlan faults = FaultPlan.NONE;
  private Optional<StrengthBudget> strength = Optional.empty();
  private boolean complete = true;
  private boolean samples;
  private boolean coverage;
  private Optional<DdsAttachment> attachment = Optional.empty();

  private SimulationSettings() {}

  /** Returns a copy that a change was made to. */
  private SimulationSettings with(Consumer<SimulationSettings> change) {
    SimulationSettings copy = new SimulationSettings();
    copy.processes = processes;
    copy.generated = generated;
    copy.limits = limits;
    copy.accepted = accepted;
    copy.recordings = recordings;
    copy.driver = driver;
    copy.faults = faults;
    copy.strength = strength;
    copy.complete = complete;
    copy.samples = samples;
    copy.coverage = coverage;
    copy.attachment = attachment;
    change.accept(copy);
    return copy;
  }

  /**
   * Returns a copy with another number of scenarios simulated in parallel, on which the result does
   * not depend.
   *
   * @param number at least 1
   */
  public SimulationSettings withProcesses(int number) {
    if (number < 1) {
      throw new IllegalArgumentException("a simulation needs a process");
    }
    return with(copy -> copy.processes = number);
  }

  /**
   * Returns a copy with other generated components, which must follow the rules for generated code;
   * the others are handwritten.
   */
  public SimulationSettings withGenerated(Set<String> names) {
    return with(copy -> copy.generated = Set.copyOf(names));
  }

  /** Returns a copy with other limits of the resources that nodes and components may use. */
  public SimulationSettings withLimits(NodeLimits other) {
    return with(copy -> copy.limits = other);
  }

  /**
   * Returns a copy with other accepted findings: a component that did not work keeps criteria from
   * being judged unless its finding is accepted.
   */
  public SimulationSettings withAccepted(Predicate<Diagnostic> other) {
    return with(copy -> copy.accepted = other);
  }

  /**
   * Returns a copy with recordings of the messages of each scenario, in {@code NAME.mcap} once the
   * scenario has ended, also by a failure of a node.
   *
   * @param folder an existing folder
   */
  public SimulationSettings withRecordings(Path folder) {
    return with(copy -> copy.recordings = Optional.of(folder));
  }

  /** Returns a copy with another driver, which starts the nodes. */
  public SimulationSettings withDriver(SimulationDriver other) {
    if (other == SimulationDriver.DDS_ATTACHED) {
      throw new IllegalArgumentException("attaching needs a domain");
    }
    return with(
        copy -> {
          copy.driver = other;
          copy.attachment = Optional.empty();
        });
  }

  /** Returns a copy with nodes that run elsewhere, so that one process is enough. */
  public SimulationSettings withAttachment(DdsAttachment where) {
    return with(
        copy -> {
          copy.processes = 1;
          copy.driver = SimulationDriver.DDS_ATTACHED;
          copy.attachment = Optional.of(where);
        });
  }

  /** Returns a copy with faults, each in an additional run of a scenario of the request. */
  public SimulationSettings withFaults(FaultPlan other) {
    return with(copy -> copy.faults = other);
  }

  /**
   * Returns a copy that measures the strength of requirements, if every scenario passes.
   *
   * @param budget empty to measure none
   */
  public SimulationSettings withStrength(Optional<StrengthBudget> budget) {
    return with(copy -> copy.strength = budget);
  }

  /**
   * Returns a copy for all scenarios of a project, or for some: then components may do in others
   * what they do not do in these.
   */
  public SimulationSettings ofAllScenarios(boolean all) {
    return with(copy -> copy.complete = all);
  }

  /** Returns a copy that keeps what the nodes read and write, message by message, or does not. */
  public SimulationSettings withSamples(boolean kept) {
    return with(copy -> copy.samples = kept);
  }

  /**
   * Returns a copy that records which values the signals of the chain have, or does not. In real
   * time nothing is recorded.
   */
  public SimulationSettings withCoverage(boolean recorded) {
    return with(copy -> copy.coverage = recorded);
  }

  public int processes() {
    return processes;
  }

  public Set<String> generated() {
    return generated;
  }

  public NodeLimits limits() {
    return limits;
  }

  public Predicate<Diagnostic> accepted() {
    return accepted;
  }

  public Optional<Path> recordings() {
    return recordings;
  }

  public SimulationDriver driver() {
    return driver;
  }

  public FaultPlan faults() {
    return faults;
  }

  /** Returns the budget of strength; empty if it is not measured, which only lock-step can. */
  public Optional<StrengthBudget> strength() {
    return strength.filter(budget -> driver == SimulationDriver.LOCKSTEP);
  }

  /** Returns whether the scenarios are all of the project. */
  public boolean complete() {
    return complete;
  }

  public boolean samples() {
    return samples;
  }

  public boolean coverage() {
    return coverage;
  }

  public Optional<DdsAttachment> attachment() {
    return attachment;
  }
}
