package dev.eventchain.simulation.wire;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about nodes on a DDS network. */
final class WireRules {

  static final Rule DDS_DOMAIN_NONE = Rule.error("dds.domain.none");
  static final Rule SIMULATION_NODE_LOST = Rule.error("simulation.node.lost");
  static final Rule SIMULATION_WIRE_UNMATCHED =
      Rule.error("simulation.wire.unmatched", CommonTrait.UNTESTED);

  private WireRules() {}
}
