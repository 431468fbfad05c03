package dev.eventchain.pipeline.simulate;

import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.fault.FaultPlan;
import dev.eventchain.simulation.scenario.Scenario;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** Faults that a run injects. */
final class ProjectFaults {

  private ProjectFaults() {}

  /**
   * Returns the faults of the simulated scenarios; a finding reports omitted ones.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if the file cannot be read
   */
  static FaultPlan selected(RunContext run, EventChain chain, List<Scenario> scenarios) {
    if (run.options().simulation().faults().isEmpty()) {
      return FaultPlan.NONE;
    }
    List<Scenario> all =
        run.options().isPartial()
            ? Scenario.readFolder(run.project().scenarios(), run.chain().bench(), warning -> {})
            : scenarios;
    FaultPlan plan =
        FaultPlan.read(run.options().simulation().faults().get(), chain, run.chain().bench(), all);
    Set<String> names = scenarios.stream().map(Scenario::name).collect(Collectors.toSet());
    plan.leftOut(names).ifPresent(run::find);
    return plan.within(names);
  }
}
