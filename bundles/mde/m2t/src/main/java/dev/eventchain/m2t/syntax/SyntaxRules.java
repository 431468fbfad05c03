package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the text of templates. */
public final class SyntaxRules {

  public static final Rule CHARSET = Rule.error("m2t.charset");
  public static final Rule LINE_ENDS = Rule.warning("m2t.line-ends");
  public static final Rule LINT_BRACKET = Rule.warning("m2t.lint.bracket", SyntaxTrait.LINT);
  public static final Rule MODULE_MISSING = Rule.error("m2t.module.missing");
  public static final Rule NESTING = Rule.error("m2t.nesting");
  public static final Rule PROTECTED_ID = Rule.error("m2t.protected.id");
  public static final Rule SYNTAX = Rule.error("m2t.syntax", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule UNSUPPORTED = Rule.error("m2t.unsupported");

  private SyntaxRules() {}
}
