package dev.eventchain.contracts;

import dev.eventchain.diagnostics.Severity;

/** Rules, in the order of reports. */
enum Rule {
  MESSAGE_UNKNOWN("contract.message.unknown", Severity.ERROR),
  FIELD_UNKNOWN("contract.field.unknown", Severity.ERROR),
  TYPE_MISMATCH("contract.type.mismatch", Severity.ERROR),
  AGE("contract.age.impossible", Severity.ERROR),
  SAFE_VALUE("contract.value.unfit", Severity.ERROR),
  TOPIC_TYPE("contract.topic.type", Severity.ERROR),
  FIELD_UNSET("contract.field.unset", Severity.ERROR),
  UNIT_MISMATCH("contract.unit.mismatch", Severity.ERROR),
  QOS_AMBIGUOUS("contract.qos.ambiguous", Severity.WARNING),
  QOS_INCOMPATIBLE("contract.qos.incompatible", Severity.ERROR),
  QOS_UNDECIDED("contract.qos.undecided", Severity.INFO),
  PUBLISHER_MISSING("contract.publisher.missing", Severity.ERROR),
  CONSUMER_MISSING("contract.consumer.missing", Severity.ERROR),
  EXTERNAL_INPUT("contract.external.input", Severity.ERROR),
  PUBLISHERS_SEVERAL("contract.publishers.several", Severity.WARNING),
  SIGNAL_TYPE("contract.signal.type", Severity.ERROR),
  SIGNAL_FIELD("contract.signal.field", Severity.WARNING),
  SIGNAL_DIRECTION("contract.signal.direction", Severity.ERROR),
  NEXTSTEP_CYCLE("chain.nextstep.cycle", Severity.ERROR),
  FLOW_CYCLE("chain.flow.cycle", Severity.WARNING),
  LATENCY_UNCONNECTED("chain.latency.unconnected", Severity.ERROR);

  private final String id;
  private final Severity severity;

  Rule(String id, Severity severity) {
    this.id = id;
    this.severity = severity;
  }

  /** Returns the id of its findings. */
  String id() {
    return id;
  }

  /** Returns the highest severity of its findings. */
  Severity severity() {
    return severity;
  }
}
