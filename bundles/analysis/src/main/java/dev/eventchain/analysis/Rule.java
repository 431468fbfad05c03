package dev.eventchain.analysis;

/** The rules, in the order in which reports name them. */
enum Rule {
  MESSAGE_UNKNOWN("contract.message.unknown"),
  FIELD_UNKNOWN("contract.field.unknown"),
  TYPE_MISMATCH("contract.type.mismatch"),
  TOPIC_TYPE("contract.topic.type"),
  FIELD_UNSET("contract.field.unset"),
  UNIT_MISMATCH("contract.unit.mismatch"),
  QOS_AMBIGUOUS("contract.qos.ambiguous"),
  QOS_INCOMPATIBLE("contract.qos.incompatible"),
  QOS_UNDECIDED("contract.qos.undecided"),
  PUBLISHER_MISSING("contract.publisher.missing"),
  CONSUMER_MISSING("contract.consumer.missing"),
  PUBLISHERS_SEVERAL("contract.publishers.several"),
  SIGNAL_TYPE("contract.signal.type"),
  SIGNAL_FIELD("contract.signal.field"),
  SIGNAL_DIRECTION("contract.signal.direction"),
  NEXTSTEP_CYCLE("chain.nextstep.cycle"),
  FLOW_CYCLE("chain.flow.cycle"),
  LATENCY_UNCONNECTED("chain.latency.unconnected");

  private final String id;

  Rule(String id) {
    this.id = id;
  }

  /** The id of its findings. */
  String id() {
    return id;
  }
}
