package dev.eventchain.simulation.tracing;

import dev.eventchain.diagnostics.Rule;

/** Rule of the finding about a trace that is none. */
final class TracingRules {

  static final Rule TRACE_UNREADABLE = Rule.error("trace.unreadable");

  private TracingRules() {}
}
