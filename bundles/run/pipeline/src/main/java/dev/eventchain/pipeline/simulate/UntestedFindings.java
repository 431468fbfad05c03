package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.Diagnostic;
import java.util.Set;

/** Findings about missing tests, rather than errors. */
public final class UntestedFindings {

  private static final Set<String> IDS =
      Set.of(
          "bench.field.unset",
          "bench.field.unwritten",
          "bench.topic.unconnected",
          "project.requirement.untested",
          "simulation.command.ignored",
          "simulation.criterion.untested",
          "simulation.fault.no-effect",
          "simulation.fault.untested",
          "simulation.latency.unmeasured",
          "simulation.node.silent",
          "simulation.rule.untested",
          "simulation.wire.unmatched");

  private UntestedFindings() {}

  /** Returns whether a finding is about something untested. */
  public static boolean include(Diagnostic found) {
    return IDS.contains(found.id());
  }
}
