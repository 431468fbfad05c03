package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about mutants of components. */
final class MutationRules {

  static final Rule MUTATION_ACCEPTED = Rule.error("mutation.accepted");
  static final Rule MUTATION_LEFT_OUT = Rule.error("mutation.left-out");
  static final Rule MUTATION_NONE = Rule.error("mutation.none");
  static final Rule MUTATION_SINCE = Rule.error("mutation.since");
  static final Rule MUTATION_SURVIVED = Rule.error("mutation.survived");
  static final Rule MUTATION_UNPROVED = Rule.error("mutation.unproved");

  private MutationRules() {}
}
