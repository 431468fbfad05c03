package dev.eventchain.pipeline.report;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about comparisons with earlier runs. */
final class ReportRules {

  static final Rule COMPARISON_UNREADABLE = Rule.error("project.comparison.unreadable");

  private ReportRules() {}
}
