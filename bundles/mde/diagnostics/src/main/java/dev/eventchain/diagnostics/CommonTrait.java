package dev.eventchain.diagnostics;

/** Properties of rules that reports and suppressions ask for. */
public enum CommonTrait implements Rule.Trait {

  /** Something was not tested, which does not mean that it is wrong. */
  UNTESTED,

  /**
   * A check or a proof is missing, so that an accepted finding would pass for one. The page of the
   * rule says so, too: {@link RulePage#mayBeSuppressed}.
   */
  UNSUPPRESSIBLE
}
