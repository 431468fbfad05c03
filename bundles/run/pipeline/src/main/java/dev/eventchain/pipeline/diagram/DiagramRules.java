package dev.eventchain.pipeline.diagram;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about diagrams. */
final class DiagramRules {

  static final Rule NOTHING = Rule.error("diagram.nothing");
  static final Rule TOO_LARGE = Rule.error("diagram.too-large");
  static final Rule UNDRAWN = Rule.error("diagram.undrawn");

  private DiagramRules() {}
}
