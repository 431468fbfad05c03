package dev.eventchain.pipeline.generate;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about generated packages. */
final class GenerateRules {

  static final Rule DEPENDENCY_UNKNOWN = Rule.warning("project.dependency.unknown");
  static final Rule TEMPLATE_PRINTED = Rule.warning("project.template.printed");

  static final Rule UNIT_UNCONVERTED = Rule.warning("project.unit.unconverted");

  private GenerateRules() {}
}
