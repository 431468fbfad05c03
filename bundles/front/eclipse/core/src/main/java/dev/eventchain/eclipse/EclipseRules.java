package dev.eventchain.eclipse;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the checks in Eclipse. */
final class EclipseRules {

  static final Rule CHECK_FAILED = Rule.error("eclipse.check.failed");
  static final Rule FINDINGS_MORE = Rule.error("eclipse.findings.more");
  static final Rule MODEL_UNCHECKED = Rule.info("eclipse.model.unchecked");
  static final Rule RULES_NONE = Rule.warning("eclipse.rules.none");
  static final Rule UNCHECKED = Rule.error("eclipse.unchecked");

  private EclipseRules() {}
}
