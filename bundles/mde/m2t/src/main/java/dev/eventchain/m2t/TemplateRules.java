package dev.eventchain.m2t;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the choice of a main template. */
final class TemplateRules {

  static final Rule MAIN_MISSING = Rule.error("m2t.main.missing");
  static final Rule MAIN_PARAMETERS = Rule.error("m2t.main.parameters");
  static final Rule NOTHING_GENERATED = Rule.error("m2t.nothing-generated");

  private TemplateRules() {}
}
