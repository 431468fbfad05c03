package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about benches. */
public final class BenchRules {

  public static final Rule BENCH_ACTUATOR_CONFLICT = Rule.error("bench.actuator.conflict");
  public static final Rule BENCH_ACTUATOR_UNKNOWN = Rule.error("bench.actuator.unknown");
  public static final Rule BENCH_FIELD_UNSET =
      Rule.error("bench.field.unset", CommonTrait.UNTESTED);
  public static final Rule BENCH_FIELD_UNWRITTEN =
      Rule.error("bench.field.unwritten", CommonTrait.UNTESTED);
  public static final Rule BENCH_INPUT_CYCLE = Rule.error("bench.input.cycle");
  public static final Rule BENCH_KEY_DUPLICATE = Rule.error("bench.key.duplicate");
  public static final Rule BENCH_KEY_MISSING = Rule.error("bench.key.missing");
  public static final Rule BENCH_KEY_UNKNOWN = Rule.error("bench.key.unknown");
  public static final Rule BENCH_LATENCY_UNKNOWN = Rule.error("bench.latency.unknown");
  public static final Rule BENCH_SYNTAX = Rule.error("bench.syntax", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule BENCH_TOPIC_UNCONNECTED =
      Rule.error("bench.topic.unconnected", CommonTrait.UNTESTED);
  public static final Rule BENCH_TOPIC_UNKNOWN = Rule.error("bench.topic.unknown");
  public static final Rule BENCH_TYPE = Rule.error("bench.type");
  public static final Rule BENCH_UNIT = Rule.error("bench.unit");
  public static final Rule BENCH_VALUE_RANGE = Rule.error("bench.value.range");
  public static final Rule BENCH_VALUE_TYPE = Rule.error("bench.value.type");
  public static final Rule MESSAGE_FIELD_MISSING = Rule.error("message.field.missing");
  public static final Rule MESSAGE_UNKNOWN = Rule.error("message.unknown");

  private BenchRules() {}
}
