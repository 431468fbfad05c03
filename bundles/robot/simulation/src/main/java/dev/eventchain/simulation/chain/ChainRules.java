package dev.eventchain.simulation.chain;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about nodes of a chain. */
final class ChainRules {

  static final Rule NODE_LEFT_OUT = Rule.warning("simulation.node.left-out");

  private ChainRules() {}
}
