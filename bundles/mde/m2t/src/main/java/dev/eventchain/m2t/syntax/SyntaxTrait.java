package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.Rule;

/** Properties of rules about templates. */
public enum SyntaxTrait implements Rule.Trait {
  /** The template is valid, but its output may be unintended. */
  LINT
}
