package dev.eventchain.pipeline.measure;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about a recorded trace of a project's nodes. */
final class MeasureRules {

  static final Rule TRACE_LATENCY_ABOVE_BOUND = Rule.warning("trace.latency.above-bound");
  static final Rule TRACE_LATENCY_EXCEEDED = Rule.error("trace.latency.exceeded");
  static final Rule TRACE_LATENCY_UNANSWERED = Rule.error("trace.latency.unanswered");
  static final Rule TRACE_LATENCY_UNMEASURED = Rule.error("trace.latency.unmeasured");
  static final Rule TRACE_LOST = Rule.error("trace.lost");
  static final Rule TRACE_MESSAGE_EARLIER = Rule.info("trace.message.earlier");
  static final Rule TRACE_MESSAGE_UNMATCHED = Rule.error("trace.message.unmatched");
  static final Rule TRACE_NODE_MISSING = Rule.warning("trace.node.missing");
  static final Rule TRACE_PERIOD_ABOVE = Rule.warning("trace.period.above");
  static final Rule TRACE_PUBLISHER_MISSING = Rule.error("trace.publisher.missing");
  static final Rule TRACE_READER = Rule.error("trace.reader");
  static final Rule TRACE_THREAD_MIXED = Rule.error("trace.thread.mixed");
  static final Rule TRACE_TIME_ABOVE = Rule.warning("trace.time.above");
  static final Rule TRACE_UNMATCHED = Rule.error("trace.unmatched");

  private MeasureRules() {}
}
