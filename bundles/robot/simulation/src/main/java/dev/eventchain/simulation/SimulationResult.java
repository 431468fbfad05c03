package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.simulation.measure.MeasuredModel;
import dev.eventchain.simulation.verdict.FaultVerdict;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.util.List;

/**
 * The result of a simulation. Everything but {@link #host} and the host times of the nodes is the
 * same in every run with the same nodes and scenarios.
 *
 * @param verdicts one for each scenario, in the order of the request
 * @param measurements what was measured of the nodes
 * @param diagnostics findings that do not belong to a criterion, such as connections that were not
 *     made ({@code topic.type.mismatch}, {@code qos.incompatible})
 * @param faults what came of each fault, in the order of the request
 * @param host how the simulation itself ran
 */
public record SimulationResult(
    List<ScenarioVerdict> verdicts,
    Measurements measurements,
    List<Diagnostic> diagnostics,
    List<FaultVerdict> faults,
    Host host) {

  /** Copies the lists. */
  public SimulationResult {
    faults = List.copyOf(faults);
    verdicts = List.copyOf(verdicts);
    diagnostics = List.copyOf(diagnostics);
  }

  /**
   * How the simulation ran on this machine.
   *
   * @param driver what brought messages from one node to another, for people
   * @param attached whether others ran the nodes
   * @param confinement what kept the nodes from harming this machine
   * @param python the version of the Python that ran the nodes
   * @param processes how many simulated at the same time
   * @param simulatedSeconds simulated time of all scenarios together
   * @param wallSeconds time that the simulation took, with the start of the processes
   * @param steppingSeconds time in which the processes simulated, summed up over them
   */
  public record Host(
      String driver,
      boolean attached,
      String confinement,
      String python,
      int processes,
      double simulatedSeconds,
      double wallSeconds,
      double steppingSeconds) {

    /** How many times faster than real time one process simulated, without its start. */
    public double realTimeFactor() {
      return steppingSeconds > 0 ? simulatedSeconds / steppingSeconds : 0;
    }
  }

  /** Whether every scenario passed. */
  public boolean passed() {
    return verdicts.stream().allMatch(ScenarioVerdict::passed);
  }

  /**
   * A copy of a chain that holds what was measured. What had been measured before is replaced; host
   * times are left out, so that equal runs make equal models.
   *
   * @param chain the chain that was simulated; stays as it is
   */
  public EventChain measuredModel(EventChain chain) {
    return MeasuredModel.of(chain, measurements, verdicts);
  }

  /** The content of {@code measurements.json}: UTF-8, LF, the members in a fixed order. */
  public byte[] toJson() {
    return MeasurementsWriter.write(this);
  }

  /**
   * The content of {@code measurements.csv}: RFC 4180 in UTF-8, a row for each number that was
   * measured in simulated time, so that equal runs make equal files.
   *
   * @param chain the chain that was simulated
   */
  public byte[] toCsv(EventChain chain) {
    return MeasurementsTable.write(this, chain);
  }
}
