package dev.eventchain.check;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about checks in editors, which check single files as well as projects. */
public final class EditorRules {

  public static final Rule CHECK_FAILED = Rule.error("editor.check.failed");
  public static final Rule FINDINGS_MORE = Rule.error("editor.findings.more");
  public static final Rule MODEL_UNCHECKED = Rule.info("editor.model.unchecked");
  public static final Rule RULES_NONE = Rule.warning("editor.rules.none");
  public static final Rule UNCHECKED = Rule.error("editor.unchecked");

  private EditorRules() {}
}
