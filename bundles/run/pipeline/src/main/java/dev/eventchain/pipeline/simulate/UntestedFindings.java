package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.Diagnostic;
import java.util.Set;

/** The findings that say that something was not tested, and not that it is wrong. */
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

  /** Whether a finding is one of them. */
  public static boolean include(Diagnostic found) {
    return IDS.contains(found.id());
  }
}
