package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.simulation.coverage.SignalCoverage;
import dev.eventchain.simulation.measure.MeasuredModel;
import dev.eventchain.simulation.verdict.FaultVerdict;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.verdict.Strength;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * The result of a simulation. Everything but {@link #host} and the host times of the nodes is the
 * same in every run with the same nodes and scenarios.
 *
 * @param verdicts one for each scenario, in the order of the request
 * @param measurements the measurements of the nodes
 * @param diagnostics findings that do not belong to a criterion, such as connections that were not
 *     made ({@code topic.type.mismatch}, {@code qos.incompatible})
 * @param faults the verdicts of the faults, in the order of the request
 * @param strength the strength of the requirements; empty if it was not measured
 * @param signals the values that signals had in the scenarios, in the order of the chain; empty if
 *     this was not recorded
 * @param host the execution of the simulation itself
 */
public record SimulationResult(
    List<ScenarioVerdict> verdicts,
    Measurements measurements,
    List<Diagnostic> diagnostics,
    List<FaultVerdict> faults,
    Optional<Strength> strength,
    List<SignalCoverage> signals,
    Host host) {

  /** Copies the lists. */
  public SimulationResult {
    faults = List.copyOf(faults);
    verdicts = List.copyOf(verdicts);
    diagnostics = List.copyOf(diagnostics);
    signals = List.copyOf(signals);
  }

  /**
   * Execution of the simulation on this machine.
   *
   * @param driver the name of the driver, for users
   * @param attached true if the nodes ran elsewhere
   * @param confinement the confinement of the nodes' processes
   * @param python the version of the Python that ran the nodes
   * @param processes number of processes that simulated in parallel
   * @param simulatedSeconds simulated time of all scenarios together
   * @param wallSeconds time that the simulation took, with the start of the processes
   * @param steppingSeconds time in which the processes simulated, summed over all of them
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

    /** Returns the speed of one process relative to real time, without its start. */
    public double realTimeFactor() {
      return steppingSeconds > 0 ? simulatedSeconds / steppingSeconds : 0;
    }
  }

  /** Returns a copy with the strength of the requirements. */
  SimulationResult withStrength(Strength measured) {
    return new SimulationResult(
        verdicts, measurements, diagnostics, faults, Optional.of(measured), signals, host);
  }

  /** Returns a copy with another finding that does not belong to a criterion. */
  SimulationResult with(Diagnostic finding) {
    List<Diagnostic> all = new ArrayList<>(diagnostics);
    all.add(finding);
    return new SimulationResult(verdicts, measurements, all, faults, strength, signals, host);
  }

  /** Returns whether every scenario passed. */
  public boolean passed() {
    return verdicts.stream().allMatch(ScenarioVerdict::passed);
  }

  /**
   * Returns a copy of a chain with the measurements. Earlier measurements are replaced; host times
   * are left out, so that equal runs produce equal models.
   *
   * @param chain the simulated chain; not modified
   */
  public EventChain measuredModel(EventChain chain) {
    return MeasuredModel.of(chain, measurements, verdicts);
  }

  /** Returns the content of {@code measurements.json}: UTF-8, LF, members in a fixed order. */
  public byte[] toJson() {
    return MeasurementsWriter.write(this);
  }

  /**
   * Returns the content of {@code measurements.csv}: RFC 4180 in UTF-8, a row for each number
   * measured in simulated time, so that equal runs produce equal files.
   *
   * @param chain the simulated chain
   */
  public byte[] toCsv(EventChain chain) {
    return MeasurementsTable.write(this, chain);
  }

  /**
   * Returns the curves of each scenario as tables, by its name: RFC 4180 in UTF-8, a row every 50
   * ms, and a column for each curve.
   */
  public SortedMap<String, byte[]> curves() {
    SortedMap<String, byte[]> tables = new TreeMap<>();
    verdicts.forEach(each -> tables.put(each.scenario(), SeriesTable.write(each.series())));
    return tables;
  }
}
