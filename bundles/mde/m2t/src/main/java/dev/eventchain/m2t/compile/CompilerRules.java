package dev.eventchain.m2t.compile;

import dev.eventchain.diagnostics.Rule;
import dev.eventchain.m2t.syntax.SyntaxTrait;

/** Rules of the findings about templates that can be read but not understood. */
final class CompilerRules {

  static final Rule FEATURE_JAVA = Rule.warning("m2t.feature.java");
  static final Rule LET_NEVER = Rule.warning("m2t.let.never");
  static final Rule LINT_PARAMETER = Rule.warning("m2t.lint.parameter", SyntaxTrait.LINT);
  static final Rule LINT_UNORDERED = Rule.warning("m2t.lint.unordered", SyntaxTrait.LINT);
  static final Rule LINT_UNUSED = Rule.warning("m2t.lint.unused", SyntaxTrait.LINT);
  static final Rule METAMODEL_UNKNOWN = Rule.error("m2t.metamodel.unknown");
  static final Rule NAME_DUPLICATE = Rule.error("m2t.name.duplicate");
  static final Rule QUERY_EMPTY = Rule.warning("m2t.query.empty");
  static final Rule QUERY_TYPE = Rule.warning("m2t.query.type");
  static final Rule SUPER = Rule.error("m2t.super");

  private CompilerRules() {}
}
