package dev.eventchain.simulation.node;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about settings and manifests of nodes. */
public final class NodeRules {

  public static final Rule DDS_DOMAIN_UNUSABLE = Rule.error("dds.domain.unusable");
  public static final Rule SIMULATION_MANIFEST = Rule.error("simulation.manifest");

  private NodeRules() {}
}
