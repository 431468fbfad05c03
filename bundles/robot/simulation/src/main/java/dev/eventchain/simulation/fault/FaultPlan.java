package dev.eventchain.simulation.fault;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.BenchReader;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Faults to inject into scenarios, each in a run of its own. Read from a YAML file. Immutable. */
public final class FaultPlan {

  /** Plan without faults. */
  public static final FaultPlan NONE = new FaultPlan(List.of());

  private final List<Fault> faults;

  FaultPlan(List<Fault> faults) {
    this.faults = List.copyOf(faults);
  }

  /**
   * Reads a file.
   *
   * @param chain the chain whose nodes and topics the faults name
   * @param bench the topics of the world and the signals that formulas may read
   * @param scenarios the scenarios that the faults may name
   * @throws DiagnosticException (INPUT) with every problem of the file: {@code fault.syntax},
   *     {@code fault.key.unknown}, {@code fault.key.duplicate}, {@code fault.key.missing}, {@code
   *     fault.value.type}, {@code fault.value.range}, {@code fault.kind}, {@code fault.unknown},
   *     {@code fault.name.duplicate}, {@code fault.none}, those of the criteria of a scenario, or
   *     that it cannot be read
   */
  public static FaultPlan read(Path file, EventChain chain, Bench bench, List<Scenario> scenarios) {
    return parse(SourceText.read(file), chain, bench, scenarios);
  }

  /** Reads a text in memory as {@link #read} does. */
  public static FaultPlan parse(
      SourceText text, EventChain chain, Bench bench, List<Scenario> scenarios) {
    return new FaultsReader(text, FaultTargets.of(chain, bench), bench, scenarios).read();
  }

  /** Returns the JSON Schema of such files. */
  public static String schema() {
    return BenchReader.resource("faults.schema.json");
  }

  /**
   * Returns the faults in the order of the file; a fault of several scenarios once for each of
   * them.
   */
  public List<Fault> faults() {
    return faults;
  }

  /** Returns the number of runs. */
  public int size() {
    return faults.size();
  }

  /** Returns the plan with the faults of some scenarios only. */
  public FaultPlan within(Collection<String> scenarios) {
    return new FaultPlan(
        faults.stream().filter(it -> scenarios.contains(it.scenario().name())).toList());
  }

  /**
   * Returns the finding that faults of other scenarios are not injected; empty if there are none.
   */
  public Optional<Diagnostic> leftOut(Collection<String> scenarios) {
    List<Fault> others =
        faults.stream().filter(it -> !scenarios.contains(it.scenario().name())).toList();
    return others.stream()
        .findFirst()
        .map(
            first ->
                Diagnostic.of(
                        FaultRules.SIMULATION_FAULT_LEFT_OUT,
                        String.format(
                            Locale.ROOT,
                            "%d of %d runs with faults are left out, as their scenarios are: the first is '%s' in %s.",
                            others.size(),
                            faults.size(),
                            first.name(),
                            first.scenario().name()),
                        first.location())
                    .withHint("Simulate all scenarios, or name theirs: --scenario NAME"));
  }
}
